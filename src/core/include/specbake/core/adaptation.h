#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>

namespace specbake {

/// Bradford's linear chromatic adaptation (ICC.1:2010, annex E): XYZ(color * matrix) looks beside
/// the white `to` as `color` does beside `from`; `from` itself goes to `to`.
/// Throws ArgumentError if `from` excites one of the three cones not at all.
SPECBAKE_API Imath::M33d adaptation(const XYZ& from, const XYZ& to);

}  // namespace specbake
