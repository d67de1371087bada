#include "nearest_grey.h"

#include "clones.h"

#include <algorithm>

namespace specbake::bench {
namespace {

SPECBENCH_CLONES
void clip(float* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const float low = values[i] > 0 ? values[i] : 0;
        values[i] = low < 1 ? low : 1;
    }
}

/// The spectrum of one colour, before clipping.
Spectrum nearestToGrey(const XYZ& t, const Observer& observer, const Imath::M33d& inverseGram) {
    const Imath::V3d dual = observer.white() * inverseGram;
    const double g = dual.dot(t) / dual.dot(observer.white());
    const Imath::V3d multipliers = (t - observer.white() * g) * inverseGram;
    Spectrum s;
    for (std::size_t m = 0; m < s.size(); ++m) s[m] = g + multipliers.dot(observer.weights()[m]);
    return s;
}

}  // namespace

NearestGrey::NearestGrey(Frame frame, Bounds bounds)
    : LinearMethod({"nearest to grey", bounds == Bounds::clipped ? "clipped" : "unclipped"},
                   std::move(frame)),
      bounds_(bounds) {}

void NearestGrey::setUp() {
    Imath::M33d gram(0.0);
    for (const Imath::V3d& w : frame().observer.weights()) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) gram[i][j] += w[i] * w[j];
        }
    }
    const Imath::M33d inverse = gram.inverse();
    Basis basis;  // the map is linear: what it does to the three primaries says all
    for (std::size_t i = 0; i < 3; ++i) {
        const RGB primary(i == 0, i == 1, i == 2);
        basis[i] = nearestToGrey(frame().xyz(primary), frame().observer, inverse);
    }
    setBasis(basis);
}

Reconstruction NearestGrey::reconstruct(const XYZ& color) const {
    Reconstruction r = LinearMethod::reconstruct(color);
    if (bounds_ == Bounds::clipped) {
        for (double& value : r.spectrum) value = std::clamp(value, 0.0, 1.0);
    }
    return r;
}

void NearestGrey::reconstructTexels(std::span<const Imath::V3f> rgb,
                                    std::span<float> spectra) const {
    LinearMethod::reconstructTexels(rgb, spectra);
    if (bounds_ == Bounds::clipped) clip(spectra.data(), spectra.size());
}

}  // namespace specbake::bench
