#include "texture/plain/exr_description.h"

#include "texture/plain/plain_exr.h"

#include <specbake/image/spectral_layout.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

namespace specbake::internal {
namespace {

/// Takes over what an attribute says; false if that is anything but plain. What the format itself
/// asks for is read elsewhere.
bool takeOver(const exr_attribute_t& attribute, ExrDescription& description) {
    static const std::set<std::string_view> format = {
        "channels",         "compression",        "dataWindow",        "displayWindow", "lineOrder",
        "pixelAspectRatio", "screenWindowCenter", "screenWindowWidth", "type"};
    static const std::set<std::string_view> own = {"spectralLayoutVersion", "Software"};
    const std::string_view name = attribute.name;
    if (format.contains(name)) return true;
    if (name == "chromaticities" && attribute.type == EXR_ATTR_CHROMATICITIES) {
        const exr_attr_chromaticities_t& c = *attribute.chromaticities;
        description.image.signs.chromaticities = Primaries{{double(c.red_x), double(c.red_y)},
                                                           {double(c.green_x), double(c.green_y)},
                                                           {double(c.blue_x), double(c.blue_y)},
                                                           {double(c.white_x), double(c.white_y)}};
        return true;
    }
    const bool ours = own.contains(name) || name.starts_with("specbake:");
    if (ours && attribute.type == EXR_ATTR_INT) {
        description.texts[std::string(name)] = std::to_string(attribute.i);
        return true;
    }
    if (attribute.type != EXR_ATTR_STRING) return false;
    const std::string value(attribute.string->str, std::size_t(attribute.string->length));
    if (ours) {
        description.texts[std::string(name)] = value;
        return true;
    }
    if (name != "capDate" && name != "DateTime") return false;
    description.image.attributes["DateTime"] = value;
    return description.texts.try_emplace("DateTime", value).second;
}

bool takeOverAll(const ExrInput& input, ExrDescription& description) {
    int count = 0;
    input.check(exr_get_attribute_count(input.get(), 0, &count));
    for (int i = 0; i < count; ++i) {
        const exr_attribute_t* attribute = nullptr;
        input.check(
            exr_get_attribute_by_index(input.get(), 0, EXR_ATTR_LIST_FILE_ORDER, i, &attribute));
        if (!takeOver(*attribute, description)) return false;
    }
    return true;
}

bool isPlainStorage(const ExrInput& input) {
    int parts = 0;
    exr_storage_t storage{};
    exr_lineorder_t order{};
    input.check(exr_get_count(input.get(), &parts));
    input.check(exr_get_storage(input.get(), 0, &storage));
    input.check(exr_get_lineorder(input.get(), 0, &order));
    const exr_compression_t compression = input.compression();
    const bool lossless = compression == EXR_COMPRESSION_NONE ||
                          compression == EXR_COMPRESSION_ZIP ||
                          compression == EXR_COMPRESSION_ZIPS || compression == EXR_COMPRESSION_PIZ;
    return parts == 1 && storage == EXR_STORAGE_SCANLINE && lossless &&
           order == EXR_LINEORDER_INCREASING_Y;
}

/// The names in OpenImageIO's order: colours, alpha, then bands by wavelength as the alphabet has
/// them; nothing for other names.
std::optional<std::vector<std::string>> plainNames(const std::set<std::string>& names) {
    std::set<std::string> bands;
    std::set<std::string> colors;
    for (const std::string& name : names) {
        (bandWavelength(name) ? bands : colors).insert(name);
    }
    const bool alpha = colors.erase("A") > 0;
    std::vector<std::string> ordered;
    if (colors == std::set<std::string>{"R", "G", "B"}) {
        ordered = {"R", "G", "B"};
    } else if (bands.empty() && (colors == std::set<std::string>{"Y"} ||
                                 colors == std::set<std::string>{"X", "Y", "Z"})) {
        ordered.assign(colors.begin(), colors.end());
    } else {
        return {};
    }
    if (alpha) ordered.emplace_back("A");
    ordered.insert(ordered.end(), bands.begin(), bands.end());
    return ordered;
}

/// False if the channels are not plain.
bool takeOverChannels(const ExrInput& input, ImageDescription& image) {
    const exr_attr_chlist_t* list = nullptr;
    input.check(exr_get_channels(input.get(), 0, &list));
    const std::span channels(list->entries, std::size_t(list->num_channels));
    std::set<std::string> names;
    for (const exr_attr_chlist_entry_t& channel : channels) {
        const bool plain = channel.x_sampling == 1 && channel.y_sampling == 1 &&
                           channel.pixel_type == channels[0].pixel_type &&
                           channel.pixel_type != EXR_PIXEL_UINT;
        if (!plain || !names.insert(channel.name.str).second) return false;
    }
    const auto ordered = plainNames(names);
    if (!ordered) return false;
    image.channels = *ordered;
    const auto alpha = std::find(ordered->begin(), ordered->end(), "A");
    if (alpha != ordered->end()) image.alpha = int(alpha - ordered->begin());
    image.associatedAlpha = image.alpha.has_value();
    image.integers = false;
    image.sampleType =
        channels[0].pixel_type == EXR_PIXEL_HALF ? TexelType::half : TexelType::float32;
    return true;
}

/// Nothing for what is no window of bounded size.
std::optional<Window> windowOf(const exr_attr_box2i_t& box) {
    const long long width = 1LL + box.max.x - box.min.x;
    const long long height = 1LL + box.max.y - box.min.y;
    const bool bounded =
        width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide;
    if (!bounded) return {};
    return Window{box.min.x, box.min.y, int(width), int(height)};
}

bool takeOverWindows(const ExrInput& input, ImageDescription& image) {
    exr_attr_box2i_t data{};
    exr_attr_box2i_t display{};
    input.check(exr_get_data_window(input.get(), 0, &data));
    input.check(exr_get_display_window(input.get(), 0, &display));
    input.check(exr_get_pixel_aspect_ratio(input.get(), 0, &image.pixelAspectRatio));
    const auto dataWindow = windowOf(data);
    const auto displayWindow = windowOf(display);
    if (!dataWindow || !displayWindow) return false;
    image.data = *dataWindow;
    image.display = *displayWindow;
    return true;
}

}  // namespace

std::optional<ExrDescription> describePlain(const ExrInput& input) {
    ExrDescription d;
    const bool plain = isPlainStorage(input) && takeOverWindows(input, d.image) &&
                       takeOverChannels(input, d.image) && takeOverAll(input, d);
    if (!plain) return {};
    const Window& w = d.image.data;
    const long long samples =
        1LL * w.width * w.height * static_cast<long long>(d.image.channels.size());
    if (input.compression() == EXR_COMPRESSION_PIZ && samples > kMostPizSamples) return {};
    return d;
}

}  // namespace specbake::internal
