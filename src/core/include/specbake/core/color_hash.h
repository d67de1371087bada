#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace specbake {

/// A hash of a colour's bits: splitmix64's finaliser (S. Vigna) over its components.
inline std::uint64_t hashOf(const std::array<float, 3>& color) {
    std::uint64_t h = 0;
    for (const float component : color) {
        h = (h ^ std::bit_cast<std::uint32_t>(component)) + 0x9e3779b97f4a7c15;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9;
        h = (h ^ (h >> 27)) * 0x94d049bb133111eb;
        h ^= h >> 31;
    }
    return h;
}

}  // namespace specbake
