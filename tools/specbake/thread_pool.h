#pragma once

#include "farm/allotment.h"
#include "guard/possible_threads.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>

namespace specbake::tool {

/// More threads than cores, where they are asked for: the libraries take of TBB's threads what
/// they find, and only the program may decide how many there are.
class ThreadPool {
  public:
    explicit ThreadPool(int threads)
        : limit_(tbb::global_control::max_allowed_parallelism,
                 std::size_t(possibleThreads(std::max(threads, allottedThreads())))) {}

  private:
    tbb::global_control limit_;
};

}  // namespace specbake::tool
