#pragma once

#include "texture/image_file.h"

namespace specbake::internal {

/// Opens a JPEG by libjpeg alone, which loads in no time. Null for what is no JPEG, and for a JPEG
/// of other than one, three or four components, or with Exif, XMP or IPTC metadata: these are
/// OpenImageIO's. Of four inks it would give a mixture: they are read here, and their metadata
/// there. Throws FileError for a JPEG that is damaged or whose size is out of bounds.
std::unique_ptr<ImageFile> openPlainJpeg(const std::string& path);

}  // namespace specbake::internal
