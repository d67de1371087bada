#include "watched_texture.h"

#include <Imath/half.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace specbake::internal {
namespace {

template <class Stored>
double load(const std::byte* at) {
    Stored value;
    std::memcpy(&value, at, sizeof value);
    return double(value);
}

/// A sample as it is stored, integers as shares of the largest.
double stored(const std::byte* at, TexelType type) {
    switch (type) {
        case TexelType::uint8:
            return load<std::uint8_t>(at) / 255;
        case TexelType::uint16:
            return load<std::uint16_t>(at) / 65535;
        case TexelType::half:
            return load<Imath::half>(at);
        case TexelType::float32:
            break;
    }
    return load<float>(at);
}

bool isNormal(const std::array<double, 3>& c) {
    const double x = 2 * c[0] - 1;
    const double y = 2 * c[1] - 1;
    const double z = 2 * c[2] - 1;
    constexpr double tolerance = 0.1;  // what 8 bits, compression and filters leave
    return z > 0 && std::abs(std::sqrt(x * x + y * y + z * z) - 1) < tolerance;
}

}  // namespace

void WatchedTexture::readRows(int first, int count, std::span<std::byte> samples) {
    texture_.readRows(first, count, samples);
    constexpr int everyRow = 16;
    const std::size_t bytes = info().bytesPerRow();
    for (int row = (first + everyRow - 1) / everyRow * everyRow; row < first + count;
         row += everyRow) {
        look(samples.subspan(bytes * std::size_t(row - first), bytes));
    }
}

void WatchedTexture::look(std::span<const std::byte> row) {
    constexpr std::size_t everyTexel = 8;
    const TextureInfo& i = info();
    if (i.channels - (i.alpha ? 1 : 0) != 3 || i.alpha == 0) return;
    const std::size_t sample = bytesPerSample(i.sampleType);
    const std::size_t texel = sample * std::size_t(i.channels);
    for (std::size_t at = 0; at < row.size(); at += texel * everyTexel) {
        std::array<double, 3> c{};
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = stored(row.data() + at + k * sample, i.sampleType);
        }
        ++seen_;
        if (isNormal(c)) ++normals_;
    }
}

bool WatchedTexture::holdsNormals() const {
    constexpr std::size_t fewest = 16;
    return seen_ >= fewest && double(normals_) >= 0.97 * double(seen_);
}

}  // namespace specbake::internal
