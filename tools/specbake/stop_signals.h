#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace specbake::tool {

/// Turns SIGINT and SIGTERM into a stop request while it lives, so that what is half-written is
/// removed before the process ends. Make it before any other thread.
class StopSignals {
  public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    std::stop_token token() const { return source_.get_token(); }

    /// Ends the process by the signal that came, if one did, as if it had not been caught.
    void passOn() const;

  private:
    sigset_t signals_;
    std::stop_source source_;
    volatile int received_ = 0;
    std::thread waiter_;
};

}  // namespace specbake::tool
