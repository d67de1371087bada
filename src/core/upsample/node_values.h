#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/spectrum.h>

#include <array>
#include <cstddef>

namespace specbake {

/// What is interpolated and stored of a spectrum, in the order of a file's channels: a preview
/// colour B, G, R (linear sRGB of the reflectance under D65, unclamped), then the 81 bands.
inline constexpr std::size_t kPreviewValues = 3;
inline constexpr std::size_t kNodeValues = kPreviewValues + kBandCount;
/// Padded to whole cache lines of 16 floats.
inline constexpr std::size_t kNodeStride = 96;

/// The values at one node; those beyond kNodeValues are 0.
struct alignas(64) NodeValues {
    std::array<float, kNodeStride> value{};
};

/// Turns spectra into node values. Linear, so that blends of node values are the values of the
/// blended spectra.
class NodeEncoder {
  public:
    NodeEncoder();
    NodeValues encode(const Spectrum& reflectance) const;

  private:
    Observer daylight_;
    Imath::M33d sRGBFromXYZ_;
};

}  // namespace specbake
