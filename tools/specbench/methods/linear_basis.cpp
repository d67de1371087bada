#include "linear_basis.h"

#include "clones.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <cmath>

namespace specbake::bench {
namespace {

using FloatBasis = std::array<std::array<float, kBandCount>, 3>;

SPECBENCH_CLONES
void blend(const FloatBasis& basis, const Imath::V3f* rgb, std::size_t count, float* out) {
    const float* red = basis[0].data();
    const float* green = basis[1].data();
    const float* blue = basis[2].data();
    for (std::size_t i = 0; i < count; ++i, out += kBandCount) {
        const Imath::V3f c = rgb[i];
        for (int m = 0; m < kBandCount; ++m) out[m] = c.x * red[m] + c.y * green[m] + c.z * blue[m];
    }
}

Spectrum combine(const Basis& basis, const Imath::V3d& c) {
    Spectrum s;
    for (std::size_t m = 0; m < s.size(); ++m) {
        s[m] = c.x * basis[0][m] + c.y * basis[1][m] + c.z * basis[2][m];
    }
    return s;
}

}  // namespace

Basis basisSpannedBy(const Basis& functions, const Frame& frame) {
    Imath::M33d colors;  // F W^T: row j is the colour of function j
    for (int j = 0; j < 3; ++j) {
        const XYZ color = frame.observer.color(functions[std::size_t(j)]);
        for (int k = 0; k < 3; ++k) colors[j][k] = color[k];
    }
    if (!(std::abs(colors.determinant()) > 1e-9)) {
        throw ArgumentError("the three functions have colours in one plane");
    }
    const Imath::M33d weights = frame.xyzFromRGB * colors.inverse();
    Basis basis;
    for (int i = 0; i < 3; ++i) {
        basis[std::size_t(i)] =
            combine(functions, Imath::V3d(weights[i][0], weights[i][1], weights[i][2]));
    }
    return basis;
}

void LinearMethod::setBasis(const Basis& basis) {
    basis_ = basis;
    for (std::size_t i = 0; i < 3; ++i) {
        std::ranges::transform(basis[i], floatBasis_[i].begin(),
                               [](double v) { return static_cast<float>(v); });
    }
}

Reconstruction LinearMethod::reconstruct(const XYZ& color) const {
    return {combine(basis_, frame().rgb(color)), true};
}

void LinearMethod::reconstructTexels(std::span<const Imath::V3f> rgb,
                                     std::span<float> spectra) const {
    blend(floatBasis_, rgb.data(), rgb.size(), spectra.data());
}

}  // namespace specbake::bench
