#pragma once

#include <specbake/core/color.h>

#include <lcms2.h>

#include <functional>
#include <string>

namespace specbake::testing {

/// ICC profiles that Little CMS writes, as their bytes.
std::string matrixProfile(const Primaries& primaries, double gamma);
std::string greyProfile(double gamma);

/// A table of `grid` nodes an axis, from `space` (RGB or CMYK, each 0 to 1) to Lab.
std::string tableProfile(cmsColorSpaceSignature space, unsigned grid,
                         const std::function<Lab(const float* device)>& color);

}  // namespace specbake::testing
