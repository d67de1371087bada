#include "texture/plain/plain_jpeg.h"

#include "texture/openimageio/openimageio_parts.h"
#include "texture/plain/jpeg_decoder.h"
#include "texture/sequential_file.h"

namespace specbake::internal {

std::unique_ptr<ImageFile> openPlainJpeg(const std::string& path) {
    if (!beginsWith(path, "\xff\xd8\xff")) return {};
    auto decoder = std::make_unique<JpegDecoder>(path);
    ImageDescription description = decoder->description();
    if (!decoder->isPlain()) {
        if (!decoder->hasInks()) return {};
        // OpenImageIO mixes the inks, but knows the metadata.
        const std::unique_ptr<ImageFile> rich = openImageIOParts(path).openImage(path, {});
        const ImageDescription& d = rich->description();
        description.attributes = d.attributes;
        description.orientation = d.orientation;
        description.notes.insert(description.notes.end(), d.notes.begin(), d.notes.end());
    }
    return std::make_unique<SequentialFile<JpegDecoder>>(path, std::move(decoder),
                                                         std::move(description));
}

}  // namespace specbake::internal
