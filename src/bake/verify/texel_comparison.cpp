#include "verify/texel_comparison.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

bool areFinite(std::span<const float> values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

}  // namespace

TexelComparison::TexelComparison(const Upsampler& model, const SampleRounding& rounding)
    : model_(model), rounding_(rounding) {
    const Observer daylight("D65");
    const Imath::M33d rgbFromXYZ =
        xyzFromRGB(*findColorSpace("lin_rec709"), daylight.white()).inverse();
    for (std::size_t m = 0; m < kBandCount; ++m) {
        previewOfBand_[m] = daylight.weights()[m] * rgbFromXYZ;
    }
}

TexelDifference TexelComparison::compare(const std::array<float, 3>& color,
                                         std::span<const float, kBandCount> bands) const {
    TexelDifference found;
    const Observer& observer = model_.observer();
    Spectrum spectrum;
    Imath::V3d allowed(kArithmetic);
    for (std::size_t m = 0; m < kBandCount; ++m) {
        spectrum[m] = double(bands[m]);
        if (!(bands[m] >= 0 && bands[m] <= 1)) ++found.outOfRange;
        allowed += observer.weights()[m] * rounding_.of(spectrum[m]);
    }
    found.finite = areFinite(color) && areFinite(bands);
    if (!found.finite) return found;
    const RGB rgb{double(color[0]), double(color[1]), double(color[2])};
    const Attainable asked = model_.attainable(model_.xyz(rgb));
    const XYZ given = observer.color(spectrum);
    const Imath::V3d difference = given - asked.color;
    found.outside = asked.outside;
    found.de2000 =
        ciede2000(labFromXYZ(asked.color, observer.white()), labFromXYZ(given, observer.white()));
    found.xyz = largestComponent(difference);
    for (int i = 0; i < 3; ++i) {
        found.beyondRounding = found.beyondRounding || std::abs(difference[i]) > allowed[i];
    }
    return found;
}

SampleDifference TexelComparison::comparePreview(std::span<const float, 3> preview,
                                                 std::span<const float, kBandCount> bands) const {
    Imath::V3d expected(0.0);
    Imath::V3d allowed(kArithmetic);
    for (std::size_t m = 0; m < kBandCount; ++m) {
        const double band = double(bands[m]);
        expected += band * previewOfBand_[m];
        for (int i = 0; i < 3; ++i) {
            allowed[i] += std::abs(previewOfBand_[m][i]) * rounding_.of(band);
        }
    }
    SampleDifference found;
    for (int i = 0; i < 3; ++i) {
        const double stored = double(preview[std::size_t(i)]);
        const double off = std::abs(stored - std::max(0.0, expected[i]));
        found.size = std::max(found.size, off);
        const bool within = off <= allowed[i] + rounding_.of(stored);
        found.beyondRounding = found.beyondRounding || !within;
    }
    return found;
}

}  // namespace specbake::internal
