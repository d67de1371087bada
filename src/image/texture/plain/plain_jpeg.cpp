#include "texture/plain/plain_jpeg.h"

#include "texture/plain/jpeg_decoder.h"
#include "texture/sequential_file.h"

namespace specbake::internal {

std::unique_ptr<ImageFile> openPlainJpeg(const std::string& path) {
    if (!beginsWith(path, "\xff\xd8\xff")) return {};
    auto decoder = std::make_unique<JpegDecoder>(path);
    if (!decoder->isPlain()) return {};
    return std::make_unique<SequentialFile<JpegDecoder>>(path, std::move(decoder));
}

}  // namespace specbake::internal
