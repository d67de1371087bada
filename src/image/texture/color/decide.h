#pragma once

#include "texture/image_file.h"

#include <specbake/image/color_meaning.h>

namespace specbake::internal {

/// What an image's numbers mean by what its file says, in the order of docs/color.md. What the file
/// says and what cannot be used gets a line in `notes`.
ColorMeaning meaningOf(const ImageDescription& image, std::vector<std::string>& notes);

}  // namespace specbake::internal
