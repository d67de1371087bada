#include "openimageio_file.h"
#include "openimageio_parts.h"

namespace specbake {

const OpenImageIOParts& openImageIOParts(const std::string& /*path*/) {
    static constexpr OpenImageIOParts parts = {openWithOpenImageIO};
    return parts;
}

}  // namespace specbake
