#pragma once

#include "texture/image_file.h"

namespace specbake::internal {

/// Opens a PNG by libpng alone, which loads in no time. Null for what is no PNG, and for a PNG that
/// is interlaced or has Exif or XMP metadata: these are OpenImageIO's. Throws FileError for a PNG
/// that is damaged or whose size is out of bounds.
std::unique_ptr<ImageFile> openPlainPng(const std::string& path);

}  // namespace specbake::internal
