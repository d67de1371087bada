#pragma once

#include "texture/color/color_signs.h"

#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// What one of the chunks cICP, iCCP, sRGB, gAMA and cHRM says (PNG, third edition, 11.3.2), into
/// `signs`. What is damaged is left aside, with a line in `notes`. Inflates no profile to more
/// than kLargestProfile bytes.
void readPngColorChunk(std::string_view name, std::string_view data, ColorSigns& signs,
                       std::vector<std::string>& notes);

/// Profiles of presses have about 3 MB.
inline constexpr std::size_t kLargestProfile = 1 << 24;

}  // namespace specbake::internal
