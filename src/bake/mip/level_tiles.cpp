#include "mip/level_tiles.h"

#include "mantissa.h"
#include "upsample/blend.h"

#include <tbb/parallel_for.h>

namespace specbake {

LevelTiles::LevelTiles(SpectralWriter& writer, SampleType type, int bits, bool alpha)
    : writer_(writer), type_(type), bits_(bits), alpha_(alpha) {}

void LevelTiles::write(const TileRow& row) {
    const ChunkGrid& level = writer_.levels()[std::size_t(row.level)];
    const int first = level.firstChunk + row.row * level.across();
    std::vector<std::vector<std::byte>> packed(std::size_t(level.across()));
    tbb::parallel_for(0, level.across(), [&](int column) {
        const int chunk = first + column;
        packed[std::size_t(column)] = writer_.pack(chunk, samplesOf(row, level.texels(chunk)));
    });
    for (int column = 0; column < level.across(); ++column) {
        writer_.write(first + column, packed[std::size_t(column)]);
    }
}

/// As SpectralWriter::pack() takes them.
std::vector<std::byte> LevelTiles::samplesOf(const TileRow& row, const Window& texels) const {
    const bool half = type_ == SampleType::half;
    const auto channels = std::size_t(writer_.channelCount());
    const auto width = std::size_t(texels.width);
    const std::size_t plane = width * bytesPerSample(type_);
    std::vector<std::byte> samples(std::size_t(texels.height) * channels * plane);
    std::byte* to = samples.data();
    for (const auto& values : row.texels) {
        const std::size_t levelWidth = values->size() / channels;
        for (std::size_t c = 0; c < channels; ++c, to += plane) {
            const auto run =
                std::span(*values).subspan(c * levelWidth + std::size_t(texels.x), width);
            storeSamples(run, half ? BlendType::half : BlendType::float32, to);
            if (half && !(alpha_ && c == 0)) roundMantissa({to, plane}, bits_);
        }
    }
    return samples;
}

}  // namespace specbake
