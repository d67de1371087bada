#pragma once

#include "image_file.h"

namespace specbake {

/// Opens a PNG that is nothing but pixels: 8 or 16 bits, no palette, not interlaced, no chunks
/// beside those that mean sRGB, no offset, or a time. Null for any other file, which is
/// OpenImageIO's to read or refuse. Throws FileError for a PNG that is not whole, plain or not, or
/// whose size is out of bounds.
std::unique_ptr<ImageFile> openPlainPng(const std::string& path);

}  // namespace specbake
