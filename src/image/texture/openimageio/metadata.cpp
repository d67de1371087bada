#include "texture/openimageio/metadata.h"

#include "texture/kept_metadata.h"

namespace specbake::internal {
namespace {

bool isVector(const OIIO::TypeDesc& type) {
    return type.basetype == OIIO::TypeDesc::FLOAT && isVectorSize(type.basevalues());
}

/// Of any size, alone: what Exif and TIFF call BYTE, SHORT and LONG.
bool isInteger(const OIIO::TypeDesc& type) {
    return type.basevalues() == 1 && type.basetype >= OIIO::TypeDesc::UINT8 &&
           type.basetype <= OIIO::TypeDesc::INT32;
}

}  // namespace

Attributes metadataOf(const OIIO::ImageSpec& spec) {
    Attributes kept;
    for (const auto& value : spec.extra_attribs) {
        const std::string name = value.name().string();
        if (!isKeptMetadata(name)) continue;
        const OIIO::TypeDesc type = value.type();
        if (type == OIIO::TypeString) {
            kept[name] = value.get_string();
        } else if (isInteger(type)) {
            kept[name] = value.get_int();
        } else if (type == OIIO::TypeFloat) {
            kept[name] = value.get_float();
        } else if (isVector(type)) {
            const auto* first = static_cast<const float*>(value.data());
            kept[name] = std::vector<float>(first, first + type.basevalues());
        }
    }
    return kept;
}

}  // namespace specbake::internal
