#include "metadata.h"
#include "row_source.h"

#include <specbake/core/error.h>
#include <specbake/image/texture_reader.h>

namespace specbake {
namespace {

SampleType sampleTypeOf(const OIIO::TypeDesc& format) {
    switch (format.basetype) {
        case OIIO::TypeDesc::UINT8:
            return SampleType::uint8;
        case OIIO::TypeDesc::UINT16:
            return SampleType::uint16;
        case OIIO::TypeDesc::HALF:
            return SampleType::half;
        default:
            return SampleType::float32;
    }
}

OIIO::TypeDesc descriptionOf(SampleType type) {
    switch (type) {
        case SampleType::uint8:
            return OIIO::TypeUInt8;
        case SampleType::uint16:
            return OIIO::TypeUInt16;
        case SampleType::half:
            return OIIO::TypeHalf;
        case SampleType::float32:
            break;
    }
    return OIIO::TypeFloat;
}

bool isXYZ(const OIIO::ImageSpec& spec) {
    return spec.nchannels >= 3 && spec.channel_name(0) == "X" && spec.channel_name(1) == "Y" &&
           spec.channel_name(2) == "Z";
}

ColorSpace automaticSpace(const OIIO::ImageSpec& spec, SampleType type) {
    if (isXYZ(spec)) return *findColorSpace("xyz");
    if (type == SampleType::uint8 || type == SampleType::uint16) return *findColorSpace("srgb");
    if (const auto* attribute =
            spec.find_attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8))) {
        const auto* c = static_cast<const float*>(attribute->data());
        const auto at = [&](int i) { return Chromaticity{double(c[i]), double(c[i + 1])}; };
        return colorSpaceFromPrimaries({at(0), at(2), at(4), at(6)});
    }
    return *findColorSpace("lin_rec709");
}

void checkChannels(const TextureInfo& info) {
    const std::string count = std::to_string(info.channels);
    if (info.channels > 4) {
        throw FileError(info.path, count + " channels; a texture has 1 to 4");
    }
    const int color = info.channels - (info.alpha ? 1 : 0);
    if (color != 1 && color != 3) {
        throw FileError(info.path, count + " channels, " + (info.alpha ? "one" : "none") +
                                       " of them alpha: neither grey nor three colours");
    }
}

/// What of the file is left aside, a line each.
std::vector<std::string> notesOn(OIIO::ImageInput& input) {
    std::vector<std::string> notes;
    if (input.seek_subimage(1, 0)) notes.push_back("only the first of its subimages is used");
    if (input.seek_subimage(0, 1)) notes.push_back("only the first of its mip levels is used");
    input.geterror();
    input.seek_subimage(0, 0);
    const int orientation = input.spec().get_int_attribute("Orientation", 1);
    if (orientation != 1) {
        notes.push_back("its orientation (Exif " + std::to_string(orientation) +
                        ") is not used: texels stay where they are stored");
    }
    return notes;
}

TextureInfo infoOf(const std::string& path, RowSource& source) {
    const OIIO::ImageSpec spec = source.spec();
    TextureInfo info;
    info.path = path;
    info.data = {spec.x, spec.y, spec.width, spec.height};
    info.display = {spec.full_x, spec.full_y, spec.full_width, spec.full_height};
    info.pixelAspectRatio = spec.get_float_attribute("PixelAspectRatio", 1.0F);
    info.channels = spec.nchannels;
    if (spec.alpha_channel >= 0 && spec.nchannels > 1) info.alpha = spec.alpha_channel;
    info.associatedAlpha = info.alpha && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    info.sampleType = sampleTypeOf(spec.format);
    checkChannels(info);
    info.automaticSpace = automaticSpace(spec, info.sampleType);
    info.attributes = metadataOf(spec);
    info.notes = notesOn(source.input());
    return info;
}

}  // namespace

struct TextureReader::Implementation {
    Implementation(const std::string& path, int threads)
        : source(path, threads), info(infoOf(path, source)) {
        source.setSampleType(descriptionOf(info.sampleType));
    }
    RowSource source;
    TextureInfo info;
};

TextureReader::TextureReader(const std::string& path, int threads)
    : implementation_(std::make_unique<Implementation>(path, threads)) {}
TextureReader::~TextureReader() = default;
TextureReader::TextureReader(TextureReader&&) noexcept = default;
TextureReader& TextureReader::operator=(TextureReader&&) noexcept = default;

const TextureInfo& TextureReader::info() const {
    return implementation_->info;
}

void TextureReader::readRows(int first, int count, std::span<std::byte> samples) {
    implementation_->source.read(first, count, samples);
}

}  // namespace specbake
