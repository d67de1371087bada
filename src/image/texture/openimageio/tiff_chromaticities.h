#pragma once

#include <specbake/core/color_space.h>

#include <optional>
#include <string>

namespace specbake::internal {

/// The primaries and the white that a directory of a TIFF names (TIFF 6.0, section 20:
/// PrimaryChromaticities and WhitePoint), which OpenImageIO 2.4.7 passes over. None if it does not
/// name both.
std::optional<Primaries> tiffChromaticities(const std::string& path, int directory);

}  // namespace specbake::internal
