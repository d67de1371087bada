#include "mip/level_tiles.h"

#include "mantissa.h"

#include <specbake/core/sampling.h>

#include <tbb/parallel_for.h>

namespace specbake::internal {

LevelTiles::LevelTiles(SpectralSink& sink, int bits) : sink_(sink), bits_(bits) {}

void LevelTiles::write(const TileRow& row) {
    const ChunkGrid& level = sink_.levels()[std::size_t(row.level)];
    const int first = level.firstChunk + row.row * level.across();
    std::vector<std::vector<std::byte>> packed(std::size_t(level.across()));
    tbb::parallel_for(0, level.across(), [&](int column) {
        const int chunk = first + column;
        packed[std::size_t(column)] = sink_.pack(chunk, samplesOf(row, level.texels(chunk)));
    });
    for (int column = 0; column < level.across(); ++column) {
        sink_.write(first + column, packed[std::size_t(column)]);
    }
}

/// As SpectralWriter::pack() takes them.
std::vector<std::byte> LevelTiles::samplesOf(const TileRow& row, const Window& texels) const {
    const bool half = sink_.sampleType() == SampleType::half;
    const auto channels = std::size_t(sink_.channelCount());
    const auto width = std::size_t(texels.width);
    const std::size_t plane = width * bytesPerSample(sink_.sampleType());
    std::vector<std::byte> samples(std::size_t(texels.height) * channels * plane);
    std::byte* to = samples.data();
    for (const auto& values : row.texels) {
        const std::size_t levelWidth = values->size() / channels;
        for (std::size_t c = 0; c < channels; ++c, to += plane) {
            const auto run =
                std::span(*values).subspan(c * levelWidth + std::size_t(texels.x), width);
            if (half && !(sink_.alpha() && c == 0)) {
                storeRounded(run, bits_, to);
            } else {
                storeSamples(run, sink_.sampleType(), to);
            }
        }
    }
    return samples;
}

}  // namespace specbake::internal
