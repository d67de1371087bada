#pragma once

#include <specbake/core/color_hash.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace specbake::internal {

/// The colours of some texels, each once, since textures repeat colours. Those of other bits are
/// others.
struct DistinctColors {
    using Color = std::array<float, 3>;

    /// `texels`: indices of `colors`.
    DistinctColors(std::span<const Color> all, std::span<const std::size_t> texels) {
        std::vector<std::uint32_t> slots(std::bit_ceil(2 * texels.size() + 1), kFree);
        for (const std::size_t texel : texels) {
            const Color& color = all[texel];
            std::size_t slot = hashOf(color) % slots.size();
            while (slots[slot] != kFree && !sameBits(colors[slots[slot]], color)) {
                slot = (slot + 1) % slots.size();
            }
            if (slots[slot] == kFree) {
                slots[slot] = std::uint32_t(colors.size());
                colors.push_back(color);
            }
            number.push_back(slots[slot]);
        }
    }

    std::vector<Color> colors;
    std::vector<std::uint32_t> number;  ///< in `colors`, of each of the texels

  private:
    static constexpr std::uint32_t kFree = ~std::uint32_t(0);

    static bool sameBits(const Color& a, const Color& b) {
        using Bits = std::array<std::uint32_t, 3>;
        return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
    }
};

}  // namespace specbake::internal
