#include "texture/kept_metadata.h"

#include <specbake/image/spectral_layout.h>

#include <algorithm>
#include <array>

namespace specbake {
namespace internal {
namespace {

/// Prefixes and names of what belongs to the old file alone.
bool isStorage(std::string_view name) {
    constexpr std::array<std::string_view, 13> prefixes = {
        "oiio:",      "openexr:",  "tiff:",         "jpeg:",     "png:",
        "ICCProfile", "specbake:", "textureformat", "wrapmodes", "averagecolor",
        "SHA-1",      "thumbnail", "Exif:YCbCr"};
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

/// The OpenEXR file layout: attributes that headers must have, or that readers take for a part's
/// structure whatever their type.
bool isOfExr(std::string_view name) {
    constexpr std::array<std::string_view, 20> names = {
        "channels",   "compression", "dataWindow",         "displayWindow",
        "lineOrder",  "tiles",       "pixelAspectRatio",   "screenWindowCenter",
        "name",       "type",        "screenWindowWidth",  "version",
        "chunkCount", "preview",     "maxSamplesPerPixel", "chromaticities",
        "view",       "multiView",   "deepImageState",     "envmap"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool fitsExr(std::string_view name) {
    constexpr std::size_t longest = 31;  // of the OpenEXR file layout, without its flag 0x400
    return !name.empty() && name.size() <= longest && !isOfExr(name);
}

/// What a name looks like in a line for a user: no end of line, and not for ever.
std::string shown(std::string name) {
    constexpr std::size_t most = 60;
    std::erase_if(name, [](char c) { return static_cast<unsigned char>(c) < ' '; });
    return name.size() <= most ? name : name.substr(0, most) + "…";
}

}  // namespace

bool isKeptMetadata(std::string_view name) {
    return !isStorage(name);
}

void keepWhatFits(Attributes& attributes, std::vector<std::string>& notes) {
    constexpr int mostShown = 3;
    std::string list;
    int dropped = 0;
    for (auto i = attributes.begin(); i != attributes.end();) {
        if (fitsExr(i->first)) {
            ++i;
            continue;
        }
        if (++dropped <= mostShown) list += (dropped == 1 ? "" : ", ") + shown(i->first);
        i = attributes.erase(i);
    }
    if (dropped == 0) return;
    if (dropped > mostShown) list += " and " + std::to_string(dropped - mostShown) + " more";
    notes.push_back("metadata under names that an EXR cannot hold are left out: " + list);
}

}  // namespace internal

bool isFreeAttributeName(std::string_view name) {
    constexpr std::array<std::string_view, 4> taken = {
        "specbake:", "oiio:", "openexr:", "spectralLayoutVersion"};
    return internal::fitsExr(name) && std::none_of(taken.begin(), taken.end(), [&](auto prefix) {
               return name.starts_with(prefix);
           });
}

}  // namespace specbake
