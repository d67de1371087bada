#include <specbake/image/limits.h>

#include <array>
#include <atomic>
#include <cstdio>

namespace specbake {
namespace {

std::atomic<std::uint64_t> mostPixels = Limits().pixels;
std::atomic<std::uint64_t> mostMemory = Limits().memory;

}  // namespace

Limits limits() {
    return {mostPixels, mostMemory};
}

void setLimits(const Limits& limits) {
    mostPixels = limits.pixels;
    mostMemory = limits.memory;
}

std::string bytesText(std::uint64_t bytes) {
    constexpr std::array units = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
    auto value = double(bytes);
    std::size_t unit = 0;
    for (; value >= 1000 && unit + 1 < units.size(); ++unit) value /= 1000;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g %s", value, units[unit]);
    return text.data();
}

}  // namespace specbake
