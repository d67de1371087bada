#pragma once

#include <cstddef>
#include <mutex>
#include <string>

namespace specbake::bench {

/// "accuracy [3/22] what" on standard error, rewritten in place, where that is a terminal; in a
/// pipe, only how long all of it took. May be shared between threads.
class Progress {
  public:
    Progress(std::string title, std::size_t steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A step begins.
    void next(const std::string& what);

  private:
    std::string title_;
    std::size_t steps_, begun_ = 0;
    double start_;  ///< seconds
    bool visible_;
    std::mutex mutex_;
};

}  // namespace specbake::bench
