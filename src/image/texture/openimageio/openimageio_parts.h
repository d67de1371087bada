#pragma once

#include "spectral/preview_file.h"
#include "texture/image_file.h"

#include <specbake/image/limits.h>
#include <specbake/image/spectral_reader.h>
#include <specbake/image/texture.h>

#include <filesystem>

namespace specbake::internal {

/// All that uses OpenImageIO, OpenColorIO or the C++ library of OpenEXR. The former brings hundreds
/// of others with it, a quarter of a second of loading, so a program may put it off until a file
/// needs it.
struct OpenImageIOParts {
    /// openWithOpenImageIO().
    std::unique_ptr<ImageFile> (*openImage)(const std::string& path,
                                            const std::optional<std::string>& part);
    /// setLimits(): a module has limits of its own.
    void (*setLimits)(const Limits& limits);
    /// storageFactsOf().
    StorageFacts (*storageFacts)(const std::string& path);
    /// createWithOpenImageIO().
    std::unique_ptr<PreviewFile> (*createPreview)(const std::filesystem::path& path,
                                                  const std::filesystem::path& file,
                                                  const SpectralHeader& like);
    /// meaningByConfig().
    std::optional<ColorMeaning> (*meaningByConfig)(const TextureInfo& texture,
                                                   const ColorWishes& wishes);
};

/// Who links specbake::image gets linked_openimageio.cpp, and OpenImageIO with the program. A
/// program that links deferred_openimageio.cpp besides loads the module specbake_openimageio on
/// the first call, and does not link OpenImageIO. Throws FileError, on the file that needs it, if
/// the module cannot be loaded.
const OpenImageIOParts& openImageIOParts(const std::string& path);

}  // namespace specbake::internal

/// The same from the module. Module and program are built together, so that C++ types and
/// exceptions may pass between them.
extern "C" SPECBAKE_API const specbake::internal::OpenImageIOParts* specbakeOpenImageIOParts();
