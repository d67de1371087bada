#pragma once

#include "texture/image_file.h"

#include <specbake/image/spectral_reader.h>

namespace specbake::internal {

/// openImageFile() by OpenImageIO alone, whatever the file.
std::unique_ptr<ImageFile> openWithOpenImageIO(const std::string& path,
                                               const std::optional<std::string>& part = {});

/// How the file is stored. Throws FileError if it cannot be opened.
StorageFacts storageFactsOf(const std::string& path);

}  // namespace specbake::internal
