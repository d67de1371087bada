#include <specbake/core/blend.h>

#include <Imath/half.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace specbake {
namespace {

constexpr std::size_t kBlock = 16;  ///< texels blended together before they go to their planes
using Tile = std::array<std::array<float, kBlock>, kNodeStride>;

void blendTexel(const Mix& mix, std::size_t column, Tile& tile) {
    const auto& [v, w] = mix;
    for (std::size_t p = 0; p < kNodeValues; ++p) {
        tile[p][column] = w[0] * v[0][p] + w[1] * v[1][p] + w[2] * v[2][p] + w[3] * v[3][p];
    }
}

void clamp(Tile& tile) {
    for (std::size_t p = 0; p < kNodeValues; ++p) {
        const float most = p < kPreviewValues ? std::numeric_limits<float>::max() : 1.0F;
        for (float& value : tile[p]) value = std::min(std::max(value, 0.0F), most);
    }
}

}  // namespace

void storeSamples(std::span<const float> values, BlendType type, std::byte* plane) {
    if (type == BlendType::float32) {
        std::memcpy(plane, values.data(), values.size_bytes());
        return;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Imath::half value = values[i];
        std::memcpy(plane + i * sizeof value, &value, sizeof value);
    }
}

void blend(std::span<const Mix> texels, BlendType type, std::byte* planes,
           std::size_t planeStride) {
    const std::size_t width = type == BlendType::half ? sizeof(Imath::half) : sizeof(float);
    Tile tile;
    for (std::size_t first = 0; first < texels.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, texels.size() - first);
        for (std::size_t i = 0; i < count; ++i) blendTexel(texels[first + i], i, tile);
        clamp(tile);
        for (std::size_t p = 0; p < kNodeValues; ++p) {
            storeSamples(std::span(tile[p]).first(count), type,
                         planes + p * planeStride + first * width);
        }
    }
}

}  // namespace specbake
