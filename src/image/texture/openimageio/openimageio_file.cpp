#include "texture/openimageio/openimageio_file.h"

#include "texture/color/lab_and_inks.h"
#include "texture/openimageio/bounds.h"
#include "texture/openimageio/luminance_chroma.h"
#include "texture/openimageio/metadata.h"
#include "texture/openimageio/row_source.h"
#include "texture/openimageio/subimages.h"
#include "texture/openimageio/tiff_chromaticities.h"
#include "texture/plain/plain_png.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <span>
#include <string_view>

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

std::optional<Primaries> chromaticitiesOf(const OIIO::ImageSpec& spec) {
    const auto* attribute =
        spec.find_attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8));
    if (attribute == nullptr) return {};
    const std::span xy(static_cast<const float*>(attribute->data()), 8);
    const auto at = [&](std::size_t i) { return Chromaticity{double(xy[i]), double(xy[i + 1])}; };
    return Primaries{at(0), at(2), at(4), at(6)};
}

std::string profileOf(const OIIO::ImageSpec& spec) {
    const auto* attribute = spec.find_attribute("ICCProfile");
    if (attribute == nullptr || attribute->type().basetype != OIIO::TypeDesc::UINT8) return {};
    return {static_cast<const char*>(attribute->data()), attribute->type().size()};
}

/// The kind of colours that are stored, where they can be had as they are.
ColorModel modelOf(const OIIO::ImageSpec& spec, const std::string& format) {
    constexpr int cieLab = 8;
    constexpr int iccLab = 9;
    const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation");
    if (photometric == cieLab) return ColorModel::cieLab;
    if (photometric == iccLab) return ColorModel::iccLab;
    // With alpha or other channels behind its four inks, a TIFF has only inks without a name.
    const bool more = spec.nchannels > 4 && spec.channel_name(0) == "ink0";
    if (spec.get_string_attribute("tiff:ColorSpace") == "CMYK" || more) return ColorModel::cmyk;
    const std::string profile = profileOf(spec);
    const bool inks = profile.size() >= 20 && profile.substr(16, 4) == "CMYK";
    if (inks && format == "psd") return ColorModel::cmykOnPaper;
    return ColorModel::rgb;
}

/// What the channels are called: inks and Lab by what they are, whatever the library says.
std::vector<std::string> channelsOf(const OIIO::ImageSpec& spec, ColorModel model) {
    std::vector<std::string> names;
    for (int c = 0; c < spec.nchannels; ++c) names.emplace_back(spec.channel_name(c));
    const auto& own = colorNames(model);
    std::copy_n(own.begin(), std::min(own.size(), names.size()), names.begin());
    return names;
}

ImageDescription describe(const RowSource& source, ColorModel model) {
    const OIIO::ImageSpec& spec = source.spec();
    ImageDescription d;
    d.data = {spec.x, spec.y, spec.width, spec.height};
    d.display = {spec.full_x, spec.full_y, spec.full_width, spec.full_height};
    d.pixelAspectRatio = spec.get_float_attribute("PixelAspectRatio", 1.0F);
    d.channels = channelsOf(spec, model);
    const int colors = int(colorNames(model).size());
    if (spec.alpha_channel >= colors) d.alpha = spec.alpha_channel;
    d.associatedAlpha = d.alpha && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    d.sampleType = sampleTypeOf(spec.format);
    d.integers = !spec.format.is_floating_point();
    d.orientation = validOrientation(spec.get_int_attribute("Orientation", 1));
    d.signs.model = model;
    d.signs.icc = profileOf(spec);
    d.signs.chromaticities = chromaticitiesOf(spec);
    d.attributes = metadataOf(spec);
    d.notes = source.remarks();
    if (!spec.format.is_floating_point() && spec.format.is_signed()) {
        d.notes.emplace_back(
            "signed integers: read as shares of the largest; those below 0 are no colours");
    }
    return d;
}

/// The same, and what else the file holds.
ImageDescription describe(const RowSource& source, ColorModel model, const std::string& path,
                          int subimage) {
    ImageDescription d = describe(source, model);
    d.parts = subimageNames(path);
    if (!d.parts.empty()) {
        d.notes.push_back("of its parts " + d.parts + " only number " + std::to_string(subimage) +
                          " is used (--part chooses)");
    }
    if (hasMipLevels(path, subimage)) {
        d.notes.emplace_back("only the first of its mip levels is used");
    }
    return d;
}

class OpenImageIOFile : public ImageFile {
  public:
    OpenImageIOFile(ImageDescription description, std::unique_ptr<RowSource> source)
        : ImageFile(std::move(description)), source_(std::move(source)) {}

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

/// What every EXR has, and by far the most have it so.
bool saysNothing(const std::string& name, const std::string& value) {
    return (name == "PixelAspectRatio" && value == "1") || name.starts_with("screenWindow");
}

}  // namespace

std::unique_ptr<ImageFile> openWithOpenImageIO(const std::string& path,
                                               const std::optional<std::string>& part) {
    checkExrBounds(path);
    if (!part) {
        if (auto chroma = openLuminanceChroma(path)) return chroma;
    }
    const int subimage = part ? subimageNumber(path, *part) : 0;
    auto source = std::make_unique<RowSource>(path, subimage);
    const std::string format = source->input().format_name();
    if (format == "openexr" && !source->spec().format.is_floating_point()) {
        throw FileError(path, "its channels hold whole numbers, as identifiers do, and no colours");
    }
    const ColorModel model = modelOf(source->spec(), format);
    if (model != ColorModel::rgb) source = std::make_unique<RowSource>(path, subimage, true);
    ImageDescription description = describe(*source, model, path, subimage);
    if (format == "png") addPngColorSigns(path, description);
    if (format == "tiff") description.signs.chromaticities = tiffChromaticities(path, subimage);
    return std::make_unique<OpenImageIOFile>(std::move(description), std::move(source));
}

StorageFacts storageFactsOf(const std::string& path) {
    checkExrBounds(path);
    RowSource source(path, 0);
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
        const std::string text = value.get_string();
        if (!saysNothing(name, text)) facts.attributes.emplace_back(name, text);
    }
    while (source.input().seek_subimage(0, facts.levels)) ++facts.levels;
    return facts;
}

}  // namespace specbake::internal
