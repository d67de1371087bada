#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace specbake::tool {
namespace {

/// ", 1:23 left"; nothing before enough is done to tell.
std::string timeLeft(double elapsed, double done) {
    constexpr double soonest = 2;  // seconds
    if (elapsed < soonest || done < 0.01) return {};
    const int seconds = int(elapsed * (1 - done) / done + 0.5);
    if (seconds >= 3600) {
        return fmt::format(", {}:{:02}:{:02} left", seconds / 3600, seconds / 60 % 60,
                           seconds % 60);
    }
    return fmt::format(", {}:{:02} left", seconds / 60, seconds % 60);
}

}  // namespace

ProgressBar::ProgressBar(std::string label, bool wanted)
    : label_(std::move(label)), shown_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    clear();
}

void ProgressBar::clear() {
    if (!drawn_.empty()) std::fputs("\r\x1b[K", stderr);
    drawn_.clear();
}

void ProgressBar::show(double done) {
    if (!shown_) return;
    constexpr int width = 40;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const std::string bar(std::size_t(done * width), '#');
    const std::string text = fmt::format("{} [{:<{}}] {:3} %{}", label_, bar, width,
                                         int(done * 100), timeLeft(elapsed.count(), done));
    if (text == drawn_) return;
    drawn_ = text;
    std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
    std::fflush(stderr);
}

}  // namespace specbake::tool
