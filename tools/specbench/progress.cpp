#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace specbake::bench {

Progress::Progress(std::size_t steps) : steps_(steps), visible_(isatty(fileno(stderr)) == 1) {}

Progress::~Progress() {
    if (visible_) std::fputs("\r\x1b[K", stderr);
}

void Progress::next(const std::string& what) {
    ++done_;
    if (!visible_) return;
    fmt::print(stderr, "\r\x1b[K[{}/{}] {}", done_, steps_, what);
    std::fflush(stderr);
}

}  // namespace specbake::bench
