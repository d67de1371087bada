#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/samples.h>
#include <specbake/core/spectrum.h>

#include <array>
#include <cstddef>

namespace specbake::internal {

/// What is interpolated and stored of a spectrum: a texel's samples (samples.h), the preview not
/// clamped, padded to whole cache lines of 16 floats.
inline constexpr std::size_t kNodeStride = 96;

/// The values at one node; those beyond kTexelSamples are 0.
struct alignas(64) NodeValues {
    std::array<float, kNodeStride> value{};
};

/// Turns spectra into node values. Linear, so that blends of node values are the values of the
/// blended spectra.
class NodeEncoder {
  public:
    /// `d65`: of the bands and the quadrature of the spectra.
    explicit NodeEncoder(const Observer& d65);
    NodeValues encode(const Spectrum& reflectance) const;

  private:
    Observer daylight_;
    Imath::M33d sRGBFromXYZ_;
};

}  // namespace specbake::internal
