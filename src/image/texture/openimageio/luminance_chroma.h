#pragma once

#include "texture/image_file.h"

namespace specbake::internal {

/// Opens an EXR of luminance and chroma (channels Y, RY and BY, the latter in every second row and
/// column), which OpenImageIO refuses or reads as if they were colours: OpenEXR's own
/// RgbaInputFile makes R, G and B of them. Null for any other file.
std::unique_ptr<ImageFile> openLuminanceChroma(const std::string& path);

}  // namespace specbake::internal
