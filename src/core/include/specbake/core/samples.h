#pragma once

#include <specbake/core/wavelengths.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace specbake {

/// A texel's samples, in the order of a file's channels: a preview colour B, G, R (linear sRGB of
/// the reflectance under D65, not below 0), then the bands.
inline constexpr std::size_t kPreviewSamples = 3;
inline constexpr std::size_t kTexelSamples = kPreviewSamples + kBandCount;

/// What a sample is stored as: IEEE 754 binary16 or binary32.
enum class SampleType { half, float32 };

inline constexpr std::array kSampleTypes = {SampleType::half, SampleType::float32};

constexpr std::size_t bytesPerSample(SampleType type) {
    return type == SampleType::half ? 2 : 4;
}

/// "half", "float".
constexpr std::string_view sampleTypeName(SampleType type) {
    return type == SampleType::half ? "half" : "float";
}

}  // namespace specbake
