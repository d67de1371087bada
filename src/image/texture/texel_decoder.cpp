#include "texture/pixel_set.h"

#include <specbake/core/error.h>
#include <specbake/image/texel_decoder.h>

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace specbake {

using namespace internal;

namespace {

template <class Stored>
Stored load(const std::byte* at) {
    Stored value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// How many values an integer type has; 0 for the others.
std::size_t valuesOf(TexelType type) {
    if (type == TexelType::uint8) return 256;
    return type == TexelType::uint16 ? 65536 : 0;
}

/// Linear values of all stored integers: one table, or one for each component.
std::vector<float> linearTable(TexelType type, const ColorMeaning& meaning) {
    const std::size_t size = valuesOf(type);
    std::vector<float> table;
    if (size == 0) return table;
    if (meaning.curves) {
        const std::size_t step = (kCurveSize - 1) / (size - 1);
        for (const std::vector<float>& curve : *meaning.curves) {
            for (std::size_t i = 0; i < size; ++i) table.push_back(curve[i * step]);
        }
        return table;
    }
    for (std::size_t i = 0; i < size; ++i) {
        table.push_back(float(linearFrom(double(i) / double(size - 1), meaning.space.transfer)));
    }
    return table;
}

/// Between two samples of a curve, and beyond its ends along its last steps.
float interpolated(const std::vector<float>& curve, float at) {
    const double place = double(at) * double(kCurveSize - 1);
    const double cell = std::clamp(std::floor(place), 0.0, double(kCurveSize - 2));
    const auto i = std::size_t(cell);
    return float(double(curve[i]) + (place - cell) * (double(curve[i + 1]) - double(curve[i])));
}

}  // namespace

TexelDecoder::TexelDecoder(const TextureInfo& info, const ColorMeaning& meaning)
    : channels_(std::size_t(info.channels)),
      colors_(channels_ - (info.alpha ? 1 : 0)),
      alpha_(info.alpha),
      associated_(info.associatedAlpha),
      type_(info.sampleType),
      transfer_(meaning.space.transfer),
      curves_(meaning.curves),
      transform_(meaning.transform),
      linearOf_(transform_ ? std::vector<float>() : linearTable(type_, meaning)),
      nextTable_(curves_ ? valuesOf(type_) : 0) {
    if (meaning.space.isXYZ() && channels_ < 3) {
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

float TexelDecoder::linear(std::size_t component, float encoded) const {
    if (curves_) return interpolated((*curves_)[component], encoded);
    return transfer_ == Transfer::linear ? encoded : float(linearFrom(double(encoded), transfer_));
}

/// Of a texel; 1 without alpha.
float TexelDecoder::opacity(const std::byte* texel) const {
    return alpha_ ? sample(texel + std::size_t(*alpha_) * bytesPerSample(type_)) : 1.0F;
}

void TexelDecoder::decode(std::span<const std::byte> samples, std::size_t count,
                          std::array<float, 3>* color, float* alpha) const {
    if (transform_) {
        decodeByTransform(samples.data(), count, color, alpha);
    } else {
        decodeByCurves(samples.data(), count, color, alpha);
    }
}

void TexelDecoder::decodeByCurves(const std::byte* texels, std::size_t count,
                                  std::array<float, 3>* color, float* alpha) const {
    const std::size_t width = bytesPerSample(type_);
    const std::size_t step = colors_ == 3 ? 1 : 0;  // grey: one for all three
    const std::size_t first = alpha_ == 0 ? 1 : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::byte* texel = texels + i * channels_ * width;
        const float opaque = opacity(texel);
        if (alpha_) alpha[i] = opaque;
        const bool divide = associated_ && opaque != 0 && opaque != 1;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::byte* at = texel + (first + c * step) * width;
            const float* table = linearOf_.data() + c * nextTable_;
            if (divide) {
                color[i][c] = linear(c, sample(at) / opaque);
            } else if (type_ == TexelType::uint8) {
                color[i][c] = table[load<std::uint8_t>(at)];
            } else if (type_ == TexelType::uint16) {
                color[i][c] = table[load<std::uint16_t>(at)];
            } else {
                color[i][c] = linear(c, sample(at));
            }
        }
    }
}

void TexelDecoder::decodeByTransform(const std::byte* texels, std::size_t count,
                                     std::array<float, 3>* color, float* alpha) const {
    const std::size_t width = bytesPerSample(type_);
    const std::size_t first = alpha_ == 0 ? 1 : 0;
    PixelSet pixels(colors_, count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::byte* texel = texels + i * channels_ * width;
        const float opaque = opacity(texel);
        if (alpha_) alpha[i] = opaque;
        const bool divide = associated_ && opaque != 0;
        std::array<float, 4> stored{};
        for (std::size_t c = 0; c < colors_; ++c) {
            const float value = sample(texel + (first + c) * width);
            stored[c] = divide ? value / opaque : value;
        }
        pixels.add(stored);
    }
    pixels.run(*transform_, color);
}

}  // namespace specbake
