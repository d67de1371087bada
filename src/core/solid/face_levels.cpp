#include "solid/face_levels.h"

#include <Imath/ImathBox.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake::internal {

namespace {

Imath::V3d absolute(const Imath::V3d& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

}  // namespace

FaceLevels::FaceLevels(const std::vector<Imath::V3d>& normals) : normals_(normals) {
    // Bounds are to lie above the rounded levels too: either takes less than a dozen roundings.
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    normals_.resize((normals.size() + kBlock - 1) / kBlock * kBlock, Imath::V3d(0.0));
    for (std::size_t first = 0; first < normals_.size(); first += kBlock) {
        Imath::Box3d box;
        for (std::size_t i = first; i < std::min(first + kBlock, normals.size()); ++i) {
            box.extendBy(normals[i]);
        }
        const Imath::V3d half = box.size() / 2;
        boxes_.push_back({box.center(), half + rounding * (absolute(box.center()) + half)});
    }
}

double FaceLevels::largestOfBlock(std::size_t block, const Imath::V3d& d) const {
    double largest = 0;
    for (std::size_t i = block * kBlock; i < (block + 1) * kBlock; ++i) {
        largest = std::max(largest, std::abs(level(i, d)));
    }
    return largest;
}

double FaceLevels::largest(const Imath::V3d& d) const {
    const Imath::V3d size = absolute(d);
    double largest = 0;
    for (std::size_t block = 0; block < boxes_.size(); ++block) {
        const Box& box = boxes_[block];
        if (std::abs(box.center.dot(d)) + box.half.dot(size) <= largest) continue;
        largest = std::max(largest, largestOfBlock(block, d));
    }
    return largest;
}

std::vector<std::size_t> FaceLevels::atLeast(double threshold, const Imath::V3d& d) const {
    const Imath::V3d size = absolute(d);
    std::vector<std::size_t> found;
    for (std::size_t block = 0; block < boxes_.size(); ++block) {
        const Box& box = boxes_[block];
        if (std::abs(box.center.dot(d)) + box.half.dot(size) < threshold) continue;
        for (std::size_t i = block * kBlock; i < (block + 1) * kBlock; ++i) {
            if (std::abs(level(i, d)) >= threshold) found.push_back(i);
        }
    }
    return found;
}

}  // namespace specbake::internal
