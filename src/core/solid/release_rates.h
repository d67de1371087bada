#pragma once

#include <specbake/core/wavelengths.h>

#include <Imath/ImathVec.h>

#include <array>
#include <cstddef>
#include <span>

namespace specbake::internal {

/// Generators, component by component, for the processor's registers: at which of them the distance
/// to a colour falls fastest.
class ReleaseRates {
  public:
    static constexpr std::size_t kSlots = (std::size_t(kBandCount) + 15) / 16 * 16;
    static constexpr std::size_t kNone = kSlots;

    /// +1 for a generator that may rise from 0, −1 for one that may fall from 1, 0 for others.
    struct alignas(64) Sides {
        std::array<double, kSlots> value{};
    };

    ReleaseRates() = default;
    explicit ReleaseRates(std::span<const Imath::V3d> vectors);

    /// The generator j with the largest (gap·w_j)²/|w_j|² of those whose release lessens the length
    /// of the gap beyond doubt, side_j gap·w_j > rounding·w_j; kNone if there is none. The same on
    /// every processor.
    std::size_t fastest(const Sides& sides, const Imath::V3d& gap,
                        const Imath::V3d& rounding) const;

    struct alignas(64) Table {
        std::array<double, kSlots> x{}, y{}, z{};
        std::array<double, kSlots> inverse{};  ///< 1/|w|², 0 where w is
    };

  private:
    Table table_;
};

}  // namespace specbake::internal
