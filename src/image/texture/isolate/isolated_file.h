#pragma once

#include "texture/image_file.h"

#include <memory>
#include <optional>
#include <string>

namespace specbake::internal {

/// Whether the file is to be read in another process (isolation.h).
bool isIsolated(const std::string& path);

/// openImageFile() in another process.
std::unique_ptr<ImageFile> openIsolated(const std::string& path,
                                        const std::optional<std::string>& part);

}  // namespace specbake::internal
