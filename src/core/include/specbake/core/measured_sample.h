#pragma once

#include <specbake/core/api.h>
#include <specbake/core/spectrum.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace specbake {

/// A measured reflectance, in [0, 1].
struct MeasuredSample {
    std::string name;
    Spectrum reflectance{};
    std::string material;  ///< one of materialNames(), or "" if it is none of these

    bool operator==(const MeasuredSample&) const = default;
};

/// Most samples that a model takes: the equations for them take time n³.
inline constexpr std::size_t kMostSamples = 2000;

/// The materials that have samples built in: skin, leaf, wood, ground.
SPECBAKE_API std::span<const std::string_view> materialNames();

}  // namespace specbake
