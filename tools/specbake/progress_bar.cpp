#include "progress_bar.h"

#include <unistd.h>

#include <cstdio>

namespace specbake::tool {

ProgressBar::ProgressBar(std::string label, bool wanted)
    : label_(std::move(label)), shown_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (percent_ >= 0) std::fputs("\r\x1b[K", stderr);
}

void ProgressBar::show(double done) {
    const int percent = int(done * 100);
    if (!shown_ || percent == percent_) return;
    percent_ = percent;
    constexpr int width = 40;
    const std::string bar(std::size_t(percent * width / 100), '#');
    std::fprintf(stderr, "\r%s [%-*s] %3d %%", label_.c_str(), width, bar.c_str(), percent);
    std::fflush(stderr);
}

}  // namespace specbake::tool
