#pragma once

#include <string>

namespace testimages {

/// A PNG of 16 palette colours (OpenImageIO reads such files but writes none), 8x8 pixels.
void writePalettePng(const std::string& path);

}  // namespace testimages
