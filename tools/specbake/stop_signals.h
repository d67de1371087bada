#pragma once

#include <stop_token>
#include <thread>

namespace specbake::tool {

/// Ends the process by the signals INT, TERM, HUP and PIPE, and XFSZ where another process sends
/// it, within a second wherever it stands, and leaves nothing behind: they are a stop request while
/// there is time, and what is half-written is removed in any case. Those that are ignored stay so.
/// A file's size beyond the limit of the process is an error of that file and no more.
///
/// One in a process, as long as its work goes on.
class StopSignals {
  public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    static std::stop_token token();

    /// Ends the process by the signal that came, if one did, as if it had not been caught.
    static void passOn();

  private:
    std::thread waiter_;
};

}  // namespace specbake::tool
