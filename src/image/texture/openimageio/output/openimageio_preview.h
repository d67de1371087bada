#pragma once

#include "spectral/preview_file.h"

#include <specbake/image/spectral_layout.h>

#include <filesystem>
#include <memory>

namespace specbake::internal {

/// A PreviewWriter's file, in the format of the name `path`, written into `file`, which is there
/// and empty.
std::unique_ptr<PreviewFile> createWithOpenImageIO(const std::filesystem::path& path,
                                                   const std::filesystem::path& file,
                                                   const SpectralHeader& like);

}  // namespace specbake::internal
