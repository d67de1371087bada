#include <specbake/core/error.h>
#include <specbake/image/texel_decoder.h>

#include <Imath/half.h>

#include <cstdint>
#include <cstring>

namespace specbake {
namespace {

template <class Stored>
Stored load(const std::byte* at) {
    Stored value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

std::vector<float> linearTable(TexelType type, Transfer transfer) {
    const bool integer = type == TexelType::uint8 || type == TexelType::uint16;
    const std::size_t size = integer ? (type == TexelType::uint8 ? 256 : 65536) : 0;
    std::vector<float> table(size);
    for (std::size_t i = 0; i < size; ++i) {
        table[i] = float(linearFrom(double(i) / double(size - 1), transfer));
    }
    return table;
}

}  // namespace

TexelDecoder::TexelDecoder(const TextureInfo& info, const ColorSpace& space)
    : channels_(info.channels),
      alpha_(info.alpha),
      associated_(info.associatedAlpha),
      type_(info.sampleType),
      transfer_(space.transfer),
      linearOf_(linearTable(info.sampleType, space.transfer)) {
    if (space.isXYZ() && channels_ < 3) {
        throw FileError(info.path, "a grey texture has no X, Y and Z");
    }
}

/// A stored sample as a number, integers as a share of their largest.
float TexelDecoder::sample(const std::byte* at) const {
    switch (type_) {
        case TexelType::uint8:
            return float(load<std::uint8_t>(at)) / 255.0F;
        case TexelType::uint16:
            return float(load<std::uint16_t>(at)) / 65535.0F;
        case TexelType::half:
            return float(load<Imath::half>(at));
        case TexelType::float32:
            break;
    }
    return load<float>(at);
}

float TexelDecoder::linear(float encoded) const {
    return transfer_ == Transfer::linear ? encoded : float(linearFrom(double(encoded), transfer_));
}

void TexelDecoder::decode(std::span<const std::byte> samples, std::size_t count,
                          std::array<float, 3>* color, float* alpha) const {
    const std::size_t width = bytesPerSample(type_);
    const auto channels = std::size_t(channels_);
    const std::size_t step = channels - (alpha_ ? 1 : 0) == 3 ? 1 : 0;  // grey: one for all three
    const std::size_t first = alpha_ == 0 ? 1 : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::byte* texel = samples.data() + i * channels * width;
        const float opacity = alpha_ ? sample(texel + std::size_t(*alpha_) * width) : 1.0F;
        const bool divide = associated_ && opacity != 0 && opacity != 1;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::byte* at = texel + (first + c * step) * width;
            if (divide) {
                color[i][c] = linear(sample(at) / opacity);
            } else if (type_ == TexelType::uint8) {
                color[i][c] = linearOf_[load<std::uint8_t>(at)];
            } else if (type_ == TexelType::uint16) {
                color[i][c] = linearOf_[load<std::uint16_t>(at)];
            } else {
                color[i][c] = linear(sample(at));
            }
        }
        if (alpha_) alpha[i] = opacity;
    }
}

}  // namespace specbake
