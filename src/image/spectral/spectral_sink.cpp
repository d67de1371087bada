#include <specbake/core/error.h>
#include <specbake/image/spectral_sink.h>

#include <algorithm>

namespace specbake {
namespace {

std::vector<ChunkGrid> rowByRow(const SpectralHeader& header) {
    return chunkGrids(header.data.width, header.data.height, {.compression = Compression::none});
}

}  // namespace

SpectralSink::SpectralSink(std::vector<ChunkGrid> levels, SampleType type, bool alpha, int bands)
    : levels_(std::move(levels)), type_(type), alpha_(alpha), bands_(bands) {}
SpectralSink::~SpectralSink() = default;

int SpectralSink::chunkCount() const {
    return levels_.back().firstChunk + levels_.back().count();
}

const ChunkGrid& SpectralSink::levelOf(int chunk) const {
    const auto next = std::upper_bound(
        levels_.begin(), levels_.end(), chunk,
        [](int number, const ChunkGrid& level) { return number < level.firstChunk; });
    return *std::prev(next);
}

std::size_t SpectralSink::planeRowBytes(int chunk) const {
    return std::size_t(levelOf(chunk).texels(chunk).width) * bytesPerSample(type_);
}

std::size_t SpectralSink::chunkBytes(int chunk) const {
    return std::size_t(levelOf(chunk).texels(chunk).height) * std::size_t(channelCount()) *
           planeRowBytes(chunk);
}

std::vector<std::byte> SpectralSink::pack(int chunk, std::vector<std::byte> samples) const {
    if (samples.size() != chunkBytes(chunk)) throw ArgumentError("a chunk of another size");
    packInPlace(chunk, samples);
    return samples;
}

RowSink::RowSink(const SpectralHeader& header, SampleType type, Take take)
    : SpectralSink(rowByRow(header), type, header.alpha, header.bands.count),
      take_(std::move(take)) {}

void RowSink::write(int chunk, std::span<const std::byte> packed) {
    take_(chunk, packed);
}

void RowSink::packInPlace(int /*chunk*/, std::vector<std::byte>& /*samples*/) const {}

}  // namespace specbake
