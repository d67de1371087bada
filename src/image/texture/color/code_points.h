#pragma once

#include "texture/color/color_signs.h"

namespace specbake::internal {

/// The space of code points, or nothing, with the reason in `problem`, for points that say nothing,
/// and for numbers that are no full-range RGB.
std::optional<ColorSpace> spaceOf(const CodePoints& points, std::string& problem);

/// Whether they are of PQ or HLG: light from a display, in absolute or relative terms, and no
/// reflectances.
bool isHighDynamicRange(const CodePoints& points);

}  // namespace specbake::internal
