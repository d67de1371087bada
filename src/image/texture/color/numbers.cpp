#include "texture/openimageio/openimageio_parts.h"

#include <specbake/core/error.h>
#include <specbake/image/color_meaning.h>
#include <specbake/image/texture.h>

#include <algorithm>
#include <cmath>

namespace specbake {

using namespace internal;

namespace {

using Pixel = std::array<float, 3>;

/// What a configuration computes in single precision, and reads from tables of curves.
constexpr float kSamePart = 1e-4F;

Pixel linearOf(const PixelTransform& transform, const Pixel& numbers) {
    Pixel linear{};
    transform.run(numbers.data(), 1, &linear);
    return linear;
}

bool isNear(const Pixel& a, const Pixel& b) {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](float x, float y) { return std::abs(x - y) <= kSamePart; });
}

/// Whether each channel of the numbers is a share of its primary, whatever the others are.
bool isCurvesAndPrimaries(const PixelTransform& transform, const std::array<Pixel, 3>& primaries) {
    if (!isNear(linearOf(transform, {0, 0, 0}), {0, 0, 0})) return false;
    for (const Pixel& numbers : {Pixel{1, 1, 1}, Pixel{0.2F, 0.5F, 0.8F}, Pixel{0.9F, 0.04F, 0.3F},
                                 Pixel{0.1F, 0.7F, 0.02F}}) {
        Pixel sum{};
        for (std::size_t i = 0; i < 3; ++i) {
            Pixel alone{};
            alone[i] = numbers[i];
            const Pixel part = linearOf(transform, alone);
            const Pixel& full = primaries[i];
            const auto largest =
                std::size_t(std::max_element(full.begin(), full.end()) - full.begin());
            const float share = part[largest] / full[largest];
            if (!isNear(part, {full[0] * share, full[1] * share, full[2] * share})) return false;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += part[c];
        }
        if (!isNear(sum, linearOf(transform, numbers))) return false;
    }
    return true;
}

/// To six decimals: what is beyond them is the rounding of single precision.
Chromaticity roundedChromaticity(const XYZ& color) {
    const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6; };
    const Chromaticity c = chromaticity(color);
    return {rounded(c.x), rounded(c.y)};
}

}  // namespace

ColorMeaning meaningOfNumbers(const ColorSpace& base, const ColorWishes& wishes) {
    if (wishes.config && wishes.space) {
        TextureInfo numbers;
        numbers.path = *wishes.config;
        numbers.channels = 3;
        if (auto meaning = openImageIOParts(numbers.path).meaningByConfig(numbers, wishes)) {
            return *std::move(meaning);
        }
    }
    ColorMeaning meaning;
    meaning.space = wishedSpace(base, wishes);
    return meaning;
}

ColorSpace linearSpaceOf(const ColorMeaning& meaning) {
    if (!meaning.transform) return meaning.space;
    const std::array<Pixel, 3> primaries = {linearOf(*meaning.transform, {1, 0, 0}),
                                            linearOf(*meaning.transform, {0, 1, 0}),
                                            linearOf(*meaning.transform, {0, 0, 1})};
    const Imath::M33d toXYZ = xyzFromRGB(meaning.space, xyzOf(meaning.space.primaries->white));
    const auto xyz = [&](const Pixel& p) {
        return XYZ(Imath::V3d(double(p[0]), double(p[1]), double(p[2])) * toXYZ);
    };
    const XYZ red = xyz(primaries[0]);
    const XYZ green = xyz(primaries[1]);
    const XYZ blue = xyz(primaries[2]);
    const XYZ white(red + green + blue);
    if (!isCurvesAndPrimaries(*meaning.transform, primaries) ||
        std::abs(white.y - 1) > double(kSamePart)) {
        throw ArgumentError(meaning.reason +
                            " is more than a curve and primaries with a white of 1: it has no "
                            "linear RGB of its own");
    }
    return colorSpaceFromPrimaries({roundedChromaticity(red), roundedChromaticity(green),
                                    roundedChromaticity(blue), roundedChromaticity(white)});
}

}  // namespace specbake
