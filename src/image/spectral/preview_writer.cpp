#include "texture/openimageio/openimageio_parts.h"

#include <specbake/image/preview_writer.h>

namespace specbake {

using namespace internal;

PreviewWriter::PreviewWriter(const std::filesystem::path& path, const SpectralHeader& like,
                             bool sync)
    : output_(path, sync),
      file_(openImageIOParts(path.string()).createPreview(path, output_.temporaryPath(), like)) {}

PreviewWriter::~PreviewWriter() = default;

void PreviewWriter::writeRow(std::span<const float> rgba) {
    file_->writeRow(rgba);
}

void PreviewWriter::commit() {
    file_->close();
    output_.commit();
}

}  // namespace specbake
