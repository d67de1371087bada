#include "scene_bits.h"

#include "half_bits.h"

#include <specbake/image/spectral_writer.h>

#include <cstring>
#include <filesystem>
#include <vector>

namespace specbake::bench {
namespace {

/// One chunk's samples: row by row, channel by channel; the preview is the texel's own RGB.
std::vector<std::byte> chunkSamples(const Texture& texture, const Method& method, int firstRow,
                                    int rows, int bits) {
    const auto width = std::size_t(texture.width);
    std::vector<float> spectra(width * kBandCount);
    std::vector<std::uint16_t> samples(std::size_t(rows) * width * kColorChannels);
    std::uint16_t* out = samples.data();
    for (int y = firstRow; y < firstRow + rows; ++y) {
        const Imath::V3f* row = texture.texels.data() + std::size_t(y) * width;
        method.reconstructTexels({row, width}, spectra);
        for (const int component : {2, 1, 0}) {  // B, G, R
            for (std::size_t x = 0; x < width; ++x) {
                *out++ = halfPattern(double(row[x][component]), bits);
            }
        }
        for (std::size_t m = 0; m < kBandCount; ++m) {
            for (std::size_t x = 0; x < width; ++x) {
                *out++ = halfPattern(double(spectra[x * kBandCount + m]), bits);
            }
        }
    }
    std::vector<std::byte> bytes(samples.size() * sizeof(std::uint16_t));
    std::memcpy(bytes.data(), samples.data(), bytes.size());
    return bytes;
}

}  // namespace

double packedBytes(const Texture& texture, const Method& method, int bits) {
    const Window window{0, 0, texture.width, texture.height};
    const auto never = std::filesystem::temp_directory_path() / "specbench_bits.exr";
    SpectralWriter writer(never, {window, window, 1, false, {}}, {});
    double bytes = 0;
    for (int chunk = 0; chunk < writer.chunkCount(); ++chunk) {
        const auto samples = chunkSamples(texture, method, writer.chunkFirstRow(chunk),
                                          writer.chunkRows(chunk), bits);
        bytes += double(writer.pack(chunk, samples).size());
    }
    return bytes;
}

}  // namespace specbake::bench
