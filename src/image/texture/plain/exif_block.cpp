#include "texture/plain/exif_block.h"

#include "texture/kept_metadata.h"

#include <libexif/exif-data.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace specbake::internal {
namespace {

struct Unref {
    void operator()(ExifData* data) const { exif_data_unref(data); }
};
using Block = std::unique_ptr<ExifData, Unref>;

/// As it is stored: libexif would mend and complete it.
Block load(std::string_view tiff) {
    Block block(exif_data_new());
    if (!block) throw std::bad_alloc();
    exif_data_unset_option(block.get(), EXIF_DATA_OPTION_FOLLOW_SPECIFICATION);
    exif_data_unset_option(block.get(), EXIF_DATA_OPTION_IGNORE_UNKNOWN_TAGS);
    const std::string whole = std::string("Exif\0\0", 6).append(tiff);
    exif_data_load_data(block.get(), reinterpret_cast<const unsigned char*>(whole.data()),
                        unsigned(whole.size()));
    return block;
}

/// Of the first directory these are read, and OpenImageIO knows them by their bare names.
constexpr std::array kOfFirst = {EXIF_TAG_IMAGE_DESCRIPTION,
                                 EXIF_TAG_MAKE,
                                 EXIF_TAG_MODEL,
                                 EXIF_TAG_ORIENTATION,
                                 EXIF_TAG_X_RESOLUTION,
                                 EXIF_TAG_Y_RESOLUTION,
                                 EXIF_TAG_RESOLUTION_UNIT,
                                 EXIF_TAG_SOFTWARE,
                                 EXIF_TAG_DATE_TIME,
                                 EXIF_TAG_ARTIST,
                                 EXIF_TAG_COPYRIGHT};

/// Those that libexif has no name for, or another than OpenImageIO.
struct Name {
    int tag;
    std::string_view name;
};
constexpr std::array<Name, 17> kOwnNames = {{{0x829a, "ExposureTime"},
                                             {0x829d, "FNumber"},
                                             {0x8827, "Exif:PhotographicSensitivity"},
                                             {0x8833, "Exif:ISOSpeed"},
                                             {0x8834, "Exif:ISOSpeedLatitudeyyy"},
                                             {0x8835, "Exif:ISOSpeedLatitudezzz"},
                                             {0x9212, "Exif:SecurityClassification"},
                                             {0x9213, "Exif:ImageHistory"},
                                             {0x9291, "Exif:SubsecTimeOriginal"},
                                             {0x9292, "Exif:SubsecTimeDigitized"},
                                             {0x9400, "Exif:Temperature"},
                                             {0x9401, "Exif:Humidity"},
                                             {0x9402, "Exif:Pressure"},
                                             {0x9403, "Exif:WaterDepth"},
                                             {0x9404, "Exif:Acceleration"},
                                             {0x9405, "Exif:CameraElevationAngle"},
                                             {0xa000, "Exif:FlashPixVersion"}}};

/// Values with a structure of their own.
constexpr std::array kOpaque = {EXIF_TAG_OECF,
                                EXIF_TAG_SUBJECT_AREA,
                                EXIF_TAG_MAKER_NOTE,
                                EXIF_TAG_SPATIAL_FREQUENCY_RESPONSE,
                                EXIF_TAG_NEW_CFA_PATTERN,
                                EXIF_TAG_DEVICE_SETTING_DESCRIPTION};

template <std::size_t N>
bool isAmong(const std::array<ExifTag, N>& tags, ExifTag tag) {
    return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

/// Empty if it is not known.
std::string nameOf(ExifTag tag, ExifIfd directory) {
    const char* name = exif_tag_get_name_in_ifd(tag, directory);
    const std::string known = name == nullptr ? "" : name;
    if (directory == EXIF_IFD_0) {
        return isAmong(kOfFirst, tag) ? known : "";
    }
    if (directory == EXIF_IFD_GPS) {
        const bool isVersion = int(tag) == EXIF_TAG_GPS_VERSION_ID;
        return known.empty() || isVersion ? "" : "GPS:" + known.substr(3);
    }
    if (isAmong(kOpaque, tag)) return "";
    const auto* own = std::find_if(kOwnNames.begin(), kOwnNames.end(),
                                   [&](const Name& n) { return n.tag == int(tag); });
    if (own != kOwnNames.end()) return std::string(own->name);
    return known.empty() ? "" : "Exif:" + known;
}

/// The quotients of its `count` pairs.
std::vector<float> quotients(const ExifEntry& entry, ExifByteOrder order) {
    const bool hasSign = entry.format == EXIF_FORMAT_SRATIONAL;
    std::vector<float> values;
    for (std::size_t i = 0; i < entry.components; ++i) {
        const unsigned char* pair = entry.data + 8 * i;
        const auto part = [&](const unsigned char* at) {
            return hasSign ? double(exif_get_slong(at, order)) : double(exif_get_long(at, order));
        };
        values.push_back(float(part(pair) / part(pair + 4)));
    }
    return values;
}

/// Up to a zero.
std::string textOf(const ExifEntry& entry) {
    const std::string_view all(reinterpret_cast<const char*>(entry.data), entry.size);
    return std::string(all.substr(0, all.find('\0')));
}

bool isVersion(ExifTag tag) {
    return tag == EXIF_TAG_EXIF_VERSION || tag == EXIF_TAG_FLASH_PIX_VERSION;
}

std::optional<AttributeValue> valueOf(const ExifEntry& entry, ExifByteOrder order) {
    const std::size_t count = entry.components;
    if (entry.data == nullptr || entry.size < count * exif_format_get_size(entry.format)) return {};
    if (isVersion(entry.tag)) {
        return entry.size == 4 ? std::optional<AttributeValue>(textOf(entry)) : std::nullopt;
    }
    switch (entry.format) {
        case EXIF_FORMAT_ASCII:
            return textOf(entry);
        case EXIF_FORMAT_BYTE:
            if (count == 1) return int(entry.data[0]);
            return {};
        case EXIF_FORMAT_SHORT:
            if (count == 1) return int(exif_get_short(entry.data, order));
            return {};
        case EXIF_FORMAT_LONG:
            if (count == 1) return int(exif_get_long(entry.data, order));
            return {};
        case EXIF_FORMAT_RATIONAL:
        case EXIF_FORMAT_SRATIONAL:
            if (count == 1) return quotients(entry, order).front();
            if (isVectorSize(count)) return quotients(entry, order);
            return {};
        default:
            return {};
    }
}

bool hasMakerNoteOfCanon(const ExifData& block) {
    const ExifEntry* make = exif_content_get_entry(block.ifd[EXIF_IFD_0], EXIF_TAG_MAKE);
    return make != nullptr && make->data != nullptr && textOf(*make) == "Canon" &&
           exif_content_get_entry(block.ifd[EXIF_IFD_EXIF], EXIF_TAG_MAKER_NOTE) != nullptr;
}

}  // namespace

std::optional<ExifFacts> readExif(std::string_view tiff) {
    const Block block = load(tiff);
    if (hasMakerNoteOfCanon(*block)) return {};
    const ExifByteOrder order = exif_data_get_byte_order(block.get());
    ExifFacts facts;
    for (const ExifIfd directory : {EXIF_IFD_0, EXIF_IFD_EXIF, EXIF_IFD_GPS}) {
        const ExifContent& content = *block->ifd[directory];
        for (const ExifEntry* entry : std::span(content.entries, content.count)) {
            const std::string name = nameOf(entry->tag, directory);
            if (name.empty()) continue;
            if (auto value = valueOf(*entry, order)) facts.attributes.emplace(name, *value);
        }
    }
    if (const auto orientation = facts.attributes.extract("Orientation")) {
        const auto* stored = std::get_if<int>(&orientation.mapped());
        if (stored != nullptr) facts.orientation = validOrientation(*stored);
    }
    std::erase_if(facts.attributes, [](const auto& a) { return !isKeptMetadata(a.first); });
    return facts;
}

}  // namespace specbake::internal
