#pragma once

#include <OpenImageIO/imageio.h>

#include <string>

namespace specbake::internal {

/// Whether a file could hold what its header says, and whether the limits() let it be read: nothing
/// is allocated on a header's word alone. Throws FileError.
void checkBounds(const std::string& path, const std::string& format, const OIIO::ImageSpec& spec);

/// The same of an EXR before a library allocates its chunks; nothing of another file.
void checkExrBounds(const std::string& path);

}  // namespace specbake::internal
