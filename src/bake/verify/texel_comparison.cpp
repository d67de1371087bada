#include "verify/texel_comparison.h"

#include "reading.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace specbake::internal {
namespace {

bool areFinite(std::span<const float> values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

}  // namespace

TexelComparison::TexelComparison(const Upsampler& model, BandWeights weights,
                                 const SampleRounding& rounding)
    : model_(model), rounding_(rounding), weights_(std::move(weights.lit)) {
    const Imath::M33d rgbFromXYZ =
        xyzFromRGB(*findColorSpace("lin_rec709"), whiteOf(weights.daylit)).inverse();
    for (const Imath::V3d& w : weights.daylit) previewOfBand_.push_back(w * rgbFromXYZ);
}

TexelDifference TexelComparison::compare(const std::array<float, 3>& color,
                                         std::span<const float> bands) const {
    TexelDifference found;
    const Observer& observer = model_.observer();
    Imath::V3d allowed(kArithmetic), sum(0.0);
    for (std::size_t m = 0; m < bands.size(); ++m) {
        const double value = double(bands[m]);
        if (!(bands[m] >= 0 && bands[m] <= 1)) ++found.outOfRange;
        sum += weights_[m] * value;
        allowed += weights_[m] * rounding_.of(value);
    }
    found.finite = areFinite(color) && areFinite(bands);
    if (!found.finite) return found;
    const RGB rgb{double(color[0]), double(color[1]), double(color[2])};
    const Attainable asked = model_.attainable(model_.xyz(rgb));
    const XYZ given(sum);
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
                                                 std::span<const float> bands) const {
    Imath::V3d expected(0.0);
    Imath::V3d allowed(kArithmetic);
    for (std::size_t m = 0; m < bands.size(); ++m) {
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
