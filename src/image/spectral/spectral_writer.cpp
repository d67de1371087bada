#include "spectral/exr_context.h"
#include "spectral/pack/piz_packer.h"
#include "spectral/pack/zip_packer.h"

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
          levels(chunkGrids(h.data.width, h.data.height, s)),
          context(file.temporaryPath(), path.string(), h, s),
          piz(context) {}

    /// The level that a chunk belongs to.
    const ChunkGrid& levelOf(int chunk) const {
        const auto after = std::find_if(levels.begin(), levels.end(), [chunk](const ChunkGrid& g) {
            return g.firstChunk > chunk;
        });
        return *(after - 1);
    }
    Window texels(int chunk) const { return levelOf(chunk).texels(chunk); }

    std::size_t planeRowBytes(int chunk) const {
        return std::size_t(texels(chunk).width) * bytesPerSample(storage.sampleType);
    }

    SpectralHeader header;
    StorageOptions storage;
    OutputFile file;
    std::vector<ChunkGrid> levels;
    ExrContext context;
    PizPacker piz;
};

SpectralWriter::SpectralWriter(const std::filesystem::path& path, const SpectralHeader& header,
                               const StorageOptions& storage)
    : implementation_(std::make_unique<Implementation>(path, header, storage)) {}

SpectralWriter::~SpectralWriter() = default;

int SpectralWriter::channelCount() const {
    return kColorChannels + (implementation_->header.alpha ? 1 : 0);
}

const std::vector<ChunkGrid>& SpectralWriter::levels() const {
    return implementation_->levels;
}

int SpectralWriter::chunkCount() const {
    return levels().back().firstChunk + levels().back().count();
}

std::size_t SpectralWriter::chunkBytes(int chunk) const {
    return std::size_t(implementation_->texels(chunk).height) * std::size_t(channelCount()) *
           implementation_->planeRowBytes(chunk);
}

std::vector<std::byte> SpectralWriter::pack(int chunk, std::vector<std::byte> samples) const {
    Implementation& i = *implementation_;
    if (samples.size() != chunkBytes(chunk)) throw ArgumentError("a chunk of another size");
    switch (i.storage.compression) {
        case Compression::zip:
        case Compression::zips:
            packZip(samples, i.planeRowBytes(chunk), i.storage.level);
            break;
        case Compression::piz:
            i.piz.pack(i.levelOf(chunk), chunk, samples);
            break;
        case Compression::none:
            break;
    }
    return samples;
}

void SpectralWriter::write(int chunk, std::span<const std::byte> packed) {
    implementation_->context.writeChunk(implementation_->levelOf(chunk), chunk, packed);
}

void SpectralWriter::commit() {
    implementation_->piz.release();
    implementation_->context.finish();
    implementation_->file.commit();
}

}  // namespace specbake
