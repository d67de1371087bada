#pragma once

#include <chrono>
#include <string>

namespace specbake::tool {

/// A bar on stderr, where that is a terminal, with the time that is left; nothing in a pipe.
class ProgressBar {
  public:
    explicit ProgressBar(std::string label, bool wanted = true);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `done` from 0 to 1.
    void show(double done);

    /// Makes room for a line of text; the next show() draws the bar again.
    void clear();

  private:
    std::string label_;
    bool shown_;
    std::string drawn_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace specbake::tool
