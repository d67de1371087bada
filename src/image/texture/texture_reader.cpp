#include "texture/image_file.h"

#include <specbake/core/error.h>
#include <specbake/image/texture_reader.h>

namespace specbake {

using namespace internal;

namespace {

bool isXYZ(const ImageDescription& image) {
    const auto& names = image.channels;
    return names.size() >= 3 && names[0] == "X" && names[1] == "Y" && names[2] == "Z";
}

ColorSpace automaticSpace(const ImageDescription& image) {
    if (isXYZ(image)) return *findColorSpace("xyz");
    const TexelType type = image.sampleType;
    if (type == TexelType::uint8 || type == TexelType::uint16) return *findColorSpace("srgb");
    if (image.chromaticities) {
        const auto& c = *image.chromaticities;
        const auto at = [&](std::size_t i) { return Chromaticity{double(c[i]), double(c[i + 1])}; };
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

TextureInfo infoOf(const std::string& path, const ImageDescription& image) {
    TextureInfo info;
    info.path = path;
    info.data = image.data;
    info.display = image.display;
    info.pixelAspectRatio = image.pixelAspectRatio;
    info.channels = int(image.channels.size());
    if (info.channels > 1) info.alpha = image.alpha;
    info.associatedAlpha = info.alpha && image.associatedAlpha;
    info.sampleType = image.sampleType;
    checkChannels(info);
    info.automaticSpace = automaticSpace(image);
    info.attributes = image.attributes;
    info.notes = image.notes;
    return info;
}

}  // namespace

Texture::~Texture() = default;

struct TextureReader::Implementation {
    explicit Implementation(const std::string& path)
        : file(openImageFile(path)), info(infoOf(path, file->description())) {}
    std::unique_ptr<ImageFile> file;
    TextureInfo info;
};

TextureReader::TextureReader(const std::string& path)
    : implementation_(std::make_unique<Implementation>(path)) {}
TextureReader::~TextureReader() = default;

const TextureInfo& TextureReader::info() const {
    return implementation_->info;
}

void TextureReader::readRows(int first, int count, std::span<std::byte> samples) {
    implementation_->file->readRows(first, count, implementation_->info.sampleType, samples);
}

}  // namespace specbake
