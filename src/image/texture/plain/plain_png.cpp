#include "texture/plain/plain_png.h"

#include "texture/plain/png_decoder.h"
#include "texture/sequential_file.h"

namespace specbake::internal {

std::unique_ptr<ImageFile> openPlainPng(const std::string& path) {
    if (!beginsWith(path, "\x89PNG\r\n\x1a\n")) return {};
    auto decoder = std::make_unique<PngDecoder>(path);
    if (decoder->isInterlaced() || decoder->hasRichMetadata()) return {};
    return std::make_unique<SequentialFile<PngDecoder>>(path, std::move(decoder));
}

void addPngColorSigns(const std::string& path, ImageDescription& description) {
    const PngDecoder decoder(path);
    const ImageDescription& d = decoder.description();
    description.signs = d.signs;
    description.notes.insert(description.notes.end(), d.notes.begin(), d.notes.end());
}

}  // namespace specbake::internal
