#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace specbake::bench {
namespace {

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

}  // namespace

Progress::Progress(std::string title, std::size_t steps)
    : title_(std::move(title)),
      steps_(steps),
      start_(now()),
      visible_(isatty(fileno(stderr)) == 1) {}

Progress::~Progress() {
    fmt::print(stderr, "{}{}: {:.1f} s\n", visible_ ? "\r\x1b[K" : "", title_, now() - start_);
}

void Progress::next(const std::string& what) {
    const std::lock_guard lock(mutex_);
    ++begun_;
    if (!visible_) return;
    fmt::print(stderr, "\r\x1b[K{} [{}/{}] {}", title_, begun_, steps_, what);
    std::fflush(stderr);
}

}  // namespace specbake::bench
