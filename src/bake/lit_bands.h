#pragma once

#include <specbake/bake/relight.h>
#include <specbake/core/wavelengths.h>

#include <Imath/ImathVec.h>

#include <array>

namespace specbake::internal {

/// What each band gives to linear Rec.709 R, G, B at reflectance 1.
using LitBands = std::array<Imath::V3f, kBandCount>;

/// The weights w_m of (1) under the light of the options, adapted to it if asked for, scaled as
/// relight.h says. Throws ArgumentError for an unknown light.
LitBands litBands(const RelightOptions& options);

}  // namespace specbake::internal
