#pragma once

#include "texture/image_file.h"

#include <optional>
#include <string_view>

namespace specbake::internal {

/// What Exif says of an image.
struct ExifFacts {
    Attributes attributes;  ///< those that are kept, as OpenImageIO names and types them
    int orientation = 1;
};

/// Of a block of Exif (CIPA DC-008), from its TIFF header on. What cannot be read of it is left
/// out. Nothing if OpenImageIO knows more: maker notes of Canon.
std::optional<ExifFacts> readExif(std::string_view tiff);

}  // namespace specbake::internal
