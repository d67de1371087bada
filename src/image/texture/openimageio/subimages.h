#pragma once

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>

namespace specbake::internal {

/// Opens a file and goes to one of its subimages, once: readers that have looked elsewhere before,
/// or failed to, do not find back (OpenImageIO 2.4.7: WebP decodes no more; EXR takes the windows
/// of one part for those of another). Throws FileError.
/// `raw`: inks and Lab come as they are stored, not as the library would mix them.
std::unique_ptr<OIIO::ImageInput> openSubimage(const std::string& path, int subimage,
                                               bool raw = false);

/// The number of the subimage of that name or number. Throws FileError that tells the names.
int subimageNumber(const std::string& path, const std::string& part);

/// "0 (left), 1 (right)"; of a format whose subimages have no names, "0, 1, …". Nothing if there is
/// only one.
std::string subimageNames(const std::string& path);

/// Whether a subimage has mip levels below its first.
bool hasMipLevels(const std::string& path, int subimage);

}  // namespace specbake::internal
