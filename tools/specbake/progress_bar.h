#pragma once

#include <string>

namespace specbake::tool {

/// A bar on stderr, where that is a terminal; nothing in a pipe.
class ProgressBar {
  public:
    explicit ProgressBar(std::string label, bool wanted = true);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `done` from 0 to 1.
    void show(double done);

  private:
    std::string label_;
    bool shown_;
    int percent_ = -1;
};

}  // namespace specbake::tool
