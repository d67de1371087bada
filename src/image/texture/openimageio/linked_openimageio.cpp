#include "texture/openimageio/color_config.h"
#include "texture/openimageio/openimageio_file.h"
#include "texture/openimageio/openimageio_parts.h"
#include "texture/openimageio/output/openimageio_preview.h"

namespace specbake::internal {

const OpenImageIOParts& openImageIOParts(const std::string& /*path*/) {
    static constexpr OpenImageIOParts parts = {openWithOpenImageIO, setLimits, storageFactsOf,
                                               createWithOpenImageIO, meaningByConfig};
    return parts;
}

}  // namespace specbake::internal
