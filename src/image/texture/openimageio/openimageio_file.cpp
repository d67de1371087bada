#include "texture/openimageio/openimageio_file.h"

#include "texture/openimageio/metadata.h"
#include "texture/openimageio/row_source.h"

#include <algorithm>

namespace specbake::internal {
namespace {

TexelType sampleTypeOf(const OIIO::TypeDesc& format) {
    switch (format.basetype) {
        case OIIO::TypeDesc::UINT8:
            return TexelType::uint8;
        case OIIO::TypeDesc::UINT16:
            return TexelType::uint16;
        case OIIO::TypeDesc::HALF:
            return TexelType::half;
        default:
            return TexelType::float32;
    }
}

OIIO::TypeDesc descriptionOf(TexelType type) {
    switch (type) {
        case TexelType::uint8:
            return OIIO::TypeUInt8;
        case TexelType::uint16:
            return OIIO::TypeUInt16;
        case TexelType::half:
            return OIIO::TypeHalf;
        case TexelType::float32:
            break;
    }
    return OIIO::TypeFloat;
}

std::optional<std::array<float, 8>> chromaticitiesOf(const OIIO::ImageSpec& spec) {
    const auto* attribute =
        spec.find_attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8));
    if (attribute == nullptr) return {};
    std::array<float, 8> xy{};
    std::copy_n(static_cast<const float*>(attribute->data()), xy.size(), xy.begin());
    return xy;
}

/// What of the file is left aside, a line each.
std::vector<std::string> notesOn(OIIO::ImageInput& input) {
    std::vector<std::string> notes;
    if (input.seek_subimage(1, 0)) notes.emplace_back("only the first of its subimages is used");
    if (input.seek_subimage(0, 1)) notes.emplace_back("only the first of its mip levels is used");
    input.geterror();
    input.seek_subimage(0, 0);
    const int orientation = input.spec().get_int_attribute("Orientation", 1);
    if (orientation != 1) {
        notes.push_back("its orientation (Exif " + std::to_string(orientation) +
                        ") is not used: texels stay where they are stored");
    }
    return notes;
}

ImageDescription describe(RowSource& source) {
    const OIIO::ImageSpec spec = source.spec();
    ImageDescription d;
    d.data = {spec.x, spec.y, spec.width, spec.height};
    d.display = {spec.full_x, spec.full_y, spec.full_width, spec.full_height};
    d.pixelAspectRatio = spec.get_float_attribute("PixelAspectRatio", 1.0F);
    for (int c = 0; c < spec.nchannels; ++c) d.channels.emplace_back(spec.channel_name(c));
    if (spec.alpha_channel >= 0) d.alpha = spec.alpha_channel;
    d.associatedAlpha = d.alpha && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    d.sampleType = sampleTypeOf(spec.format);
    d.chromaticities = chromaticitiesOf(spec);
    d.attributes = metadataOf(spec);
    d.notes = notesOn(source.input());
    return d;
}

class OpenImageIOFile : public ImageFile {
  public:
    explicit OpenImageIOFile(std::unique_ptr<RowSource> source)
        : ImageFile(describe(*source)), source_(std::move(source)) {}

    std::optional<std::string> text(const std::string& attribute) const override {
        const auto* value = source_->spec().find_attribute(attribute);
        if (value == nullptr) return {};
        if (value->type() != OIIO::TypeString && value->type() != OIIO::TypeInt) return {};
        return value->get_string();
    }

  private:
    void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) override {
        source_->read(first, count, descriptionOf(type), samples);
    }

    std::unique_ptr<RowSource> source_;
};

}  // namespace

std::unique_ptr<ImageFile> openWithOpenImageIO(const std::string& path) {
    return std::make_unique<OpenImageIOFile>(std::make_unique<RowSource>(path));
}

StorageFacts storageFactsOf(const std::string& path) {
    RowSource source(path);
    const OIIO::ImageSpec& spec = source.spec();
    StorageFacts facts;
    facts.channels = spec.nchannels;
    facts.sampleType = spec.format.c_str();
    facts.compression = spec.get_string_attribute("compression", "none");
    facts.tileWidth = spec.tile_width;
    facts.tileHeight = spec.tile_height;
    for (const auto& value : spec.extra_attribs) {
        const std::string name = value.name().string();
        if (name.starts_with("oiio:") || name == "compression") continue;
        facts.attributes.emplace_back(name, value.get_string());
    }
    while (source.input().seek_subimage(0, facts.levels)) ++facts.levels;
    return facts;
}

}  // namespace specbake::internal
