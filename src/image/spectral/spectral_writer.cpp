#include "spectral/exr_context.h"
#include "spectral/pack/piz_packer.h"
#include "spectral/pack/zip_packer.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>
#include <specbake/image/spectral_writer.h>

namespace specbake {

using namespace internal;

namespace {

const StorageOptions& checked(const StorageOptions& storage) {
    if (storage.level < 1 || storage.level > StorageOptions::kHighestLevel) {
        throw ArgumentError("compression levels go from 1 to " +
                            std::to_string(StorageOptions::kHighestLevel));
    }
    return storage;
}

}  // namespace

struct SpectralWriter::Implementation {
    Implementation(const std::filesystem::path& path, const SpectralHeader& header,
                   const StorageOptions& s)
        : storage(s),
          file(path, s.sync),
          context(file.temporaryPath(), path.string(), header, s),
          piz(context) {}

    StorageOptions storage;
    OutputFile file;
    ExrContext context;
    PizPacker piz;
};

SpectralWriter::SpectralWriter(const std::filesystem::path& path, const SpectralHeader& header,
                               const StorageOptions& storage)
    : SpectralSink(chunkGrids(header.data.width, header.data.height, checked(storage)),
                   storage.sampleType, header.alpha, header.bands.count),
      implementation_(std::make_unique<Implementation>(path, header, storage)) {
    if (storage.compression != Compression::none) return;
    std::uint64_t bytes = 0;
    for (int chunk = 0; chunk < chunkCount(); ++chunk) bytes += chunkBytes(chunk);
    implementation_->context.reserve(bytes);
}

SpectralWriter::~SpectralWriter() = default;

void SpectralWriter::packInPlace(int chunk, std::vector<std::byte>& samples) const {
    Implementation& i = *implementation_;
    switch (i.storage.compression) {
        case Compression::zip:
        case Compression::zips:
            packZip(samples, planeRowBytes(chunk), i.storage.level);
            break;
        case Compression::piz:
            i.piz.pack(levelOf(chunk), chunk, samples);
            break;
        case Compression::none:
            break;
    }
}

void SpectralWriter::write(int chunk, std::span<const std::byte> packed) {
    implementation_->context.writeChunk(levelOf(chunk), chunk, packed);
}

void SpectralWriter::commit() {
    implementation_->piz.release();
    implementation_->context.finish();
    implementation_->file.commit();
}

}  // namespace specbake
