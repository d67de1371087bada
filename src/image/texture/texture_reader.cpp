#include "texture/color/decide.h"
#include "texture/color/lab_and_inks.h"
#include "texture/data_names.h"
#include "texture/image_file.h"
#include "texture/kept_metadata.h"
#include "texture/select/channel_choice.h"
#include "texture/select/channel_names.h"
#include "texture/select/oriented_file.h"
#include "texture/select/recorded_options.h"
#include "texture/select/selected_channels.h"

#include <specbake/core/error.h>
#include <specbake/image/texture_reader.h>

namespace specbake {

using namespace internal;

namespace {

void checkChannels(const TextureInfo& info) {
    const std::string count = std::to_string(info.channels);
    if (isInks(info.model)) return;  // four, or four and alpha
    const int color = info.channels - (info.alpha ? 1 : 0);
    if (color != 1 && color != 3) {
        throw FileError(info.path, count + " channels, " + (info.alpha ? "one" : "none") +
                                       " of them alpha: neither grey nor three colours");
    }
}

std::string orientationNote(int orientation) {
    return "its orientation (Exif " + std::to_string(orientation) +
           ") is not used: texels stay where they are stored (--orient turns them)";
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
    info.model = image.signs.model;
    checkChannels(info);
    info.notes = image.notes;
    if (image.orientation != 1) info.notes.push_back(orientationNote(image.orientation));
    info.color = meaningOf(image, info.notes);
    info.attributes = image.attributes;
    return info;
}

std::unique_ptr<ImageFile> open(const std::string& path, const ReadOptions& options) {
    std::string reason;
    if (!options.isValid(&reason)) throw ArgumentError(path + ": " + reason);
    std::unique_ptr<ImageFile> file = openImageFile(path, options.part);
    const ImageDescription& all = file->description();
    file = withChannels(std::move(file), options.channels.empty()
                                             ? automaticChannels(path, all)
                                             : namedChannels(path, all, options.channels));
    if (!options.orient || file->description().orientation == 1) return file;
    return std::make_unique<OrientedFile>(std::move(file));
}

}  // namespace

Texture::~Texture() = default;

struct TextureReader::Implementation {
    Implementation(const std::string& path, const ReadOptions& options)
        : file(open(path, options)), info(infoOf(path, file->description())) {
        keepWhatFits(info.attributes, info.notes);
        info.attributes.merge(recorded(options));
        if (auto remark = remarkOnName(path)) info.notes.push_back(std::move(*remark));
        if (info.color.source != ColorSource::sampleType) return;
        if (auto remark = remarkOnSpace(path, info.color.space)) {
            info.notes.push_back(std::move(*remark));
        }
    }
    std::unique_ptr<ImageFile> file;
    TextureInfo info;
};

TextureReader::TextureReader(const std::string& path, const ReadOptions& options)
    : implementation_(std::make_unique<Implementation>(path, options)) {}
TextureReader::~TextureReader() = default;

const TextureInfo& TextureReader::info() const {
    return implementation_->info;
}

void TextureReader::readRows(int first, int count, std::span<std::byte> samples) {
    implementation_->file->readRows(first, count, implementation_->info.sampleType, samples);
}

}  // namespace specbake
