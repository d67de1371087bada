#pragma once

#include <Imath/ImathVec.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace specbake::internal {

/// Places, coordinates apart, so that many are looked at together: whole vectors of them, those
/// behind the last infinitely far.
struct Places {
    std::vector<double> x, y, z;
    std::size_t count = 0;

    void add(const Imath::V3d& place);
};

/// Which of the places are near enough to count, in their order, and how much each counts.
struct Near {
    std::span<const std::uint64_t> indices;
    std::span<const double> weights;

    /// Where they are, and room for those of the largest set.
    std::vector<std::uint64_t> indexRoom;
    std::vector<double> weightRoom;
};

/// The weights exp(−|p − p_k|²/2h²) that are at least 2^-40: less changes no reflectance by more.
/// Without an allocation where `near` had the room before.
void weighNear(const Places& places, const Imath::V3d& p, double h, Near& near);

}  // namespace specbake::internal
