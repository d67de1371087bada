#pragma once

#include <specbake/core/color.h>

#include <Imath/ImathVec.h>

namespace specbake::internal {

/// Where a colour lies when samples near it are looked for: CIELAB under the observer's white, with
/// lightness halved, since a material's spectrum keeps its shape as it darkens, and chroma
/// compressed, since saturated samples are few:
///
///     p = (L*/2, a* f, b* f),   f = ln(1 + κ C*) / (κ C*),   C* = √(a*² + b*²),   κ = 0.03
///
/// Distances are lengths of differences.
Imath::V3d placeOf(const XYZ& color, const XYZ& white);

}  // namespace specbake::internal
