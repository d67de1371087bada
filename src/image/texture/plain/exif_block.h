#pragma once

#include "texture/image_file.h"

#include <optional>
#include <string_view>

namespace specbake::internal {

/// What a block of Exif (CIPA DC-008), from its TIFF header on, says of an image, under the names
/// and as the types that OpenImageIO has for it. What cannot be read of it is left out. Nothing if
/// OpenImageIO knows more: maker notes of Canon.
std::optional<Attributes> readExif(std::string_view tiff);

/// Reads the orientation out of the attributes, and removes what is not kept.
void keepMetadata(ImageDescription& description);

}  // namespace specbake::internal
