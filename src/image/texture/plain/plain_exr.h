#pragma once

#include "texture/image_file.h"

namespace specbake::internal {

/// Samples of an image, of all channels together, up to which openPlainExr() takes one with PIZ:
/// beyond, OpenImageIO's start costs less than the C library's unpacking, which is a fifth slower.
inline constexpr long long kMostPizSamples = 1 << 22;

/// Opens an EXR that is nothing but pixels: one part of scan lines, without loss, channels of one
/// type that are grey, RGB, XYZ or the bands of a spectral image, no attributes beside those that
/// the format asks for, chromaticities, a date and what this project writes. Null for any other
/// file, which is OpenImageIO's to read or refuse.
std::unique_ptr<ImageFile> openPlainExr(const std::string& path);

}  // namespace specbake::internal
