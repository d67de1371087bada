#include "metadata.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace specbake {
namespace {

/// Prefixes and names of what belongs to the old file alone.
bool isStorage(std::string_view name) {
    constexpr std::array<std::string_view, 12> prefixes = {
        "oiio:",     "openexr:",      "tiff:",     "jpeg:",        "png:",  "ICCProfile",
        "specbake:", "textureformat", "wrapmodes", "averagecolor", "SHA-1", "thumbnail"};
    constexpr std::array<std::string_view, 14> names = {"compression",
                                                        "chromaticities",
                                                        "PixelAspectRatio",
                                                        "screenWindowCenter",
                                                        "screenWindowWidth",
                                                        "Orientation",
                                                        "planarconfig",
                                                        "Software",
                                                        "channels",
                                                        "spectralLayoutVersion",
                                                        "type",
                                                        "version",
                                                        "chunkCount",
                                                        "name"};
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](auto prefix) { return name.starts_with(prefix); }) ||
           std::find(names.begin(), names.end(), name) != names.end();
}

bool isVector(const OIIO::TypeDesc& type) {
    const std::size_t count = type.basevalues();
    return type.basetype == OIIO::TypeDesc::FLOAT &&
           (count == 2 || count == 3 || count == 9 || count == 16);
}

}  // namespace

Attributes metadataOf(const OIIO::ImageSpec& spec) {
    Attributes kept;
    for (const auto& value : spec.extra_attribs) {
        const std::string name = value.name().string();
        constexpr std::size_t longestName = 255;  // OpenEXR's
        if (isStorage(name) || name.size() > longestName) continue;
        const OIIO::TypeDesc type = value.type();
        if (type == OIIO::TypeString) {
            kept[name] = value.get_string();
        } else if (type == OIIO::TypeInt || type == OIIO::TypeUInt) {
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

}  // namespace specbake
