#include "texture/pixel_set.h"

#include <specbake/core/color_hash.h>

#include <algorithm>
#include <bit>

namespace specbake::internal {

PixelSet::PixelSet(std::size_t channels, std::size_t expected) : channels_(channels) {
    different_.reserve(channels * expected);
    which_.reserve(expected);
}

void PixelSet::add(const std::array<float, 4>& stored) {
    const std::uint64_t hash = hashOf({stored[0], stored[1], stored[2]}) ^
                               std::bit_cast<std::uint32_t>(stored[3]) * 0x9e3779b1U;
    std::uint32_t& slot = slots_[(hash ^ hash >> 32) % kSlots];
    const bool known =
        slot != 0 && std::equal(stored.begin(), stored.begin() + std::ptrdiff_t(channels_),
                                different_.begin() + std::ptrdiff_t((slot - 1) * channels_));
    if (!known) {
        different_.insert(different_.end(), stored.begin(),
                          stored.begin() + std::ptrdiff_t(channels_));
        slot = std::uint32_t(different_.size() / channels_);
    }
    which_.push_back(slot - 1);
}

void PixelSet::run(const PixelTransform& transform, std::array<float, 3>* linear) const {
    std::vector<std::array<float, 3>> colors(different_.size() / channels_);
    transform.run(different_.data(), colors.size(), colors.data());
    for (std::size_t i = 0; i < which_.size(); ++i) linear[i] = colors[which_[i]];
}

}  // namespace specbake::internal
