#pragma once

#include <functional>
#include <stop_token>

namespace specbake::internal {

/// What happens to a band of rows, told by its number: `read` and `write` to one at a time and in
/// order, `process` to several at once.
struct Stages {
    std::function<void(int)> read;
    std::function<void(int)> process;
    std::function<void(int)> write;
    std::size_t bandBytes = 0;  ///< about what a band takes while it is under way; 0: little
};

/// Sends bands 0 to count - 1 through the stages on `threads` threads (0: all cores), a bounded
/// number of bands at a time: fewer where the limits() of memory ask for it, at least one. Throws
/// what a stage throws, or Cancelled.
void runPipeline(int count, const Stages& stages, int threads, const std::stop_token& stop);

/// How many threads `threads` means here.
int threadCount(int threads);

}  // namespace specbake::internal
