#pragma once

#include "texture/image_file.h"

namespace specbake::internal {

/// Opens a PNG by libpng alone, which loads in no time. Null for what is no PNG, and for a PNG that
/// is interlaced or has Exif or XMP metadata: these are OpenImageIO's. Throws FileError for a PNG
/// that is damaged or whose size is out of bounds.
std::unique_ptr<ImageFile> openPlainPng(const std::string& path);

/// What a PNG says of its colours, with remarks on it, for whoever reads its pixels another way.
void addPngColorSigns(const std::string& path, ImageDescription& description);

}  // namespace specbake::internal
