#include "exr_context.h"
#include "piz_packer.h"
#include "zip_packer.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>
#include <specbake/image/spectral_writer.h>

#include <algorithm>

namespace specbake {
namespace {

const StorageOptions& checked(const StorageOptions& storage) {
    if (storage.sampleType != SampleType::half && storage.sampleType != SampleType::float32) {
        throw ArgumentError("spectral images are stored as half or float");
    }
    if (storage.level < 1 || storage.level > StorageOptions::kHighestLevel) {
        throw ArgumentError("compression levels go from 1 to 12");
    }
    return storage;
}

}  // namespace

struct SpectralWriter::Implementation {
    Implementation(const std::filesystem::path& path, const SpectralHeader& h,
                   const StorageOptions& s)
        : header(h),
          storage(checked(s)),
          file(path),
          context(file.temporaryPath(), path.string(), h, s) {}

    std::size_t planeRowBytes() const {
        return std::size_t(header.data.width) * bytesPerSample(storage.sampleType);
    }

    SpectralHeader header;
    StorageOptions storage;
    OutputFile file;
    ExrContext context;
};

SpectralWriter::SpectralWriter(const std::filesystem::path& path, const SpectralHeader& header,
                               const StorageOptions& storage)
    : implementation_(std::make_unique<Implementation>(path, header, storage)) {}

SpectralWriter::~SpectralWriter() = default;

int SpectralWriter::channelCount() const {
    return kColorChannels + (implementation_->header.alpha ? 1 : 0);
}

int SpectralWriter::chunkCount() const {
    const int rows = rowsPerChunk(implementation_->storage.compression);
    return (implementation_->header.data.height + rows - 1) / rows;
}

int SpectralWriter::chunkFirstRow(int chunk) const {
    return chunk * rowsPerChunk(implementation_->storage.compression);
}

int SpectralWriter::chunkRows(int chunk) const {
    return std::min(rowsPerChunk(implementation_->storage.compression),
                    implementation_->header.data.height - chunkFirstRow(chunk));
}

std::size_t SpectralWriter::chunkBytes(int chunk) const {
    return std::size_t(chunkRows(chunk)) * std::size_t(channelCount()) *
           implementation_->planeRowBytes();
}

std::vector<std::byte> SpectralWriter::pack(int chunk, std::span<const std::byte> samples) const {
    const Implementation& i = *implementation_;
    if (samples.size() != chunkBytes(chunk)) throw ArgumentError("a chunk of another size");
    switch (i.storage.compression) {
        case Compression::zip:
        case Compression::zips:
            return packZip(samples, i.planeRowBytes(), i.storage.level);
        case Compression::piz:
            return packPiz(i.context, i.header.data.y + chunkFirstRow(chunk), samples);
        case Compression::none:
            break;
    }
    return {samples.begin(), samples.end()};
}

void SpectralWriter::write(int chunk, std::span<const std::byte> packed) {
    const ExrContext& context = implementation_->context;
    context.check(exr_write_scanline_chunk(context.get(), 0,
                                           implementation_->header.data.y + chunkFirstRow(chunk),
                                           packed.data(), packed.size()));
}

void SpectralWriter::commit() {
    implementation_->context.finish();
    implementation_->file.commit();
}

}  // namespace specbake
