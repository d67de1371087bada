#include "texture/plain/jpeg_decoder.h"

#include "texture/plain/exif_block.h"

#include <specbake/core/error.h>
#include <specbake/image/limits.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace specbake::internal {
namespace {

constexpr int kExifMarker = JPEG_APP0 + 1;
constexpr int kIccMarker = JPEG_APP0 + 2;
constexpr int kPhotoshopMarker = JPEG_APP0 + 13;

// How the data of these markers begin.
constexpr std::string_view kExif("Exif\0\0", 6);
constexpr std::string_view kXmp = "http://ns.adobe.com/xap/1.0/";

/// Of what Photoshop keeps, OpenImageIO reads IPTC, where it is the first.
bool beginsWithIptc(std::string_view data) {
    constexpr std::string_view start("Photoshop 3.0\0008BIM\4\4", 20);
    return data.substr(0, start.size()) == start.substr(0, data.size());
}

std::vector<std::string> namesOf(int components) {
    if (components == 1) return {"Y"};
    if (components == 4) return {"C", "M", "Y", "K"};
    return {"R", "G", "B"};
}

}  // namespace

/// libjpeg leaves a call that went wrong by longjmp, past frames that own nothing.
template <class Call>
void JpegDecoder::guarded(Call&& call) {
    if (setjmp(errors_.leave) != 0) fail();
    call();
}

void JpegDecoder::fail() const {
    throw FileError(path_, std::string("JPEG: ") + errors_.message.data());
}

void JpegDecoder::onError(j_common_ptr jpeg) {
    auto* errors = reinterpret_cast<Errors*>(jpeg->err);
    errors->manager.format_message(jpeg, errors->message.data());
    std::longjmp(errors->leave, 1);
}

/// Level -1 warns of damaged data, for which libjpeg makes up pixels.
void JpegDecoder::onMessage(j_common_ptr jpeg, int level) {
    auto* errors = reinterpret_cast<Errors*>(jpeg->err);
    if (level >= 0) return;
    if (!errors->lenient) onError(jpeg);
    errors->complained = true;
}

JpegDecoder::JpegDecoder(const std::string& path) : path_(path), stream_(openStream(path)) {
    jpeg_.err = jpeg_std_error(&errors_.manager);
    errors_.manager.error_exit = onError;
    errors_.manager.emit_message = onMessage;
    readHeader();
    describe();
    readProfile();
    readMarkers();
    readDensity();
}

void JpegDecoder::readHeader() {
    // A progressive file is unpacked as a whole.
    const long mostMemory = long(std::min(limits().memory, std::uint64_t(1) << 32));
    constexpr unsigned longestMarker = 0xffff;
    guarded([this, mostMemory] {
        jpeg_create_decompress(&jpeg_);
        jpeg_.mem->max_memory_to_use = mostMemory;
        jpeg_stdio_src(&jpeg_, stream_.get());
        for (const int marker : {kExifMarker, kIccMarker, kPhotoshopMarker, JPEG_COM}) {
            jpeg_save_markers(&jpeg_, marker, longestMarker);
        }
        jpeg_read_header(&jpeg_, TRUE);
    });
    checkSides(path_, jpeg_.image_width, jpeg_.image_height);
    const int components = jpeg_.num_components;
    plain_ = components == 1 || components == 3 || components == 4;
    if (!plain_) return;
    if (components == 4) jpeg_.out_color_space = JCS_CMYK;
    guarded([this] { jpeg_start_decompress(&jpeg_); });
}

void JpegDecoder::describe() {
    ImageDescription& d = description_;
    d.data = {0, 0, int(jpeg_.image_width), int(jpeg_.image_height)};
    d.display = d.data;
    d.channels = namesOf(jpeg_.num_components);
    if (jpeg_.num_components == 4) {
        // Adobe's programs store what ink leaves, and mark their files.
        d.signs.model = jpeg_.saw_Adobe_marker != 0 ? ColorModel::cmykOnPaper : ColorModel::cmyk;
    }
    d.sampleType = TexelType::uint8;
}

/// The profile, which may go through several markers.
void JpegDecoder::readProfile() {
    JOCTET* bytes = nullptr;
    unsigned size = 0;
    errors_.lenient = true;
    guarded([&] { jpeg_read_icc_profile(&jpeg_, &bytes, &size); });
    errors_.lenient = false;
    if (errors_.complained) {
        description_.notes.emplace_back("its ICC profile is damaged, and not used");
    }
    const std::unique_ptr<JOCTET, decltype(&std::free)> owner(bytes, &std::free);
    if (bytes != nullptr) {
        description_.signs.icc.assign(reinterpret_cast<const char*>(bytes), size);
    }
}

void JpegDecoder::readMarkers() {
    for (auto* marker = jpeg_.marker_list; marker != nullptr; marker = marker->next) {
        const std::string_view data(reinterpret_cast<const char*>(marker->data),
                                    marker->data_length);
        if (marker->marker == JPEG_COM) {
            // A comment may end in a zero, as strings of C do.
            description_.attributes.emplace("ImageDescription",
                                            std::string(data.substr(0, data.find('\0'))));
        } else if (marker->marker == kExifMarker) {
            readExifOrXmp(data);
        } else if (marker->marker == kPhotoshopMarker) {
            plain_ = plain_ && !beginsWithIptc(data);
        }
    }
}

void JpegDecoder::readExifOrXmp(std::string_view data) {
    if (data.starts_with(kXmp)) plain_ = false;
    if (!data.starts_with(kExif)) return;
    auto exif = readExif(data.substr(kExif.size()));
    plain_ = plain_ && exif && !hasExif_;
    if (!plain_) return;
    description_.attributes.merge(exif->attributes);
    description_.orientation = exif->orientation;
    hasExif_ = true;
}

/// What JFIF says of the resolution goes before what Exif says; a density of 1 is none.
void JpegDecoder::readDensity() {
    Attributes& attributes = description_.attributes;
    const auto stated = [&](const char* name) {
        const auto found = attributes.find(name);
        const auto* value =
            found == attributes.end() ? nullptr : std::get_if<float>(&found->second);
        return value == nullptr ? 0 : *value;
    };
    auto x = float(jpeg_.X_density);
    auto y = float(jpeg_.Y_density);
    if (x == 0 || y == 0) {
        x = stated("XResolution");
        y = stated("YResolution");
        if (x == 0 || y == 0) return;
    }
    description_.pixelAspectRatio = x / y;  // as the programs that write densities mean it
    if (x != 1 && y != 1) {
        attributes["XResolution"] = x;
        attributes["YResolution"] = y;
    }
    constexpr std::array units = {"none", "in", "cm"};
    if (attributes.contains("XResolution") && jpeg_.density_unit < units.size()) {
        attributes["ResolutionUnit"] = std::string(units[jpeg_.density_unit]);
    }
}

void JpegDecoder::readRow(std::byte* samples) {
    auto* row = reinterpret_cast<JSAMPROW>(samples);
    guarded([&] { jpeg_read_scanlines(&jpeg_, &row, 1); });
    if (jpeg_.output_scanline < jpeg_.output_height) return;
    guarded([this] { jpeg_finish_decompress(&jpeg_); });
}

}  // namespace specbake::internal
