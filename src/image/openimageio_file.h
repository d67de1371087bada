#pragma once

#include "image_file.h"

namespace specbake {

/// openImageFile() by OpenImageIO alone, whatever the file.
std::unique_ptr<ImageFile> openWithOpenImageIO(const std::string& path, int threads);

}  // namespace specbake
