#include "texture/kept_metadata.h"

#include <algorithm>
#include <array>

namespace specbake::internal {
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

}  // namespace

bool isKeptMetadata(std::string_view name) {
    constexpr std::size_t longestName = 255;  // OpenEXR's
    return !isStorage(name) && name.size() <= longestName;
}

}  // namespace specbake::internal
