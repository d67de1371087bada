#pragma once

#include "spectral/preview_file.h"

#include <specbake/image/spectral_layout.h>

#include <filesystem>
#include <memory>

namespace specbake::internal {

/// A PreviewWriter's file, in any format that OpenImageIO writes.
std::unique_ptr<PreviewFile> createWithOpenImageIO(const std::filesystem::path& path,
                                                   const SpectralHeader& like);

}  // namespace specbake::internal
