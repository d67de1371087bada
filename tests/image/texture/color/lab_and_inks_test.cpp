#include "texture/color/lab_and_inks.h"

#include <specbake/core/color_space.h>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

using namespace specbake;
using namespace specbake::internal;

namespace {

const XYZ kD50(0.9642, 1.0, 0.8249);

Lab decoded(ColorModel model, TexelType type, const std::array<float, 3>& stored) {
    std::array<float, 3> linear{};
    transformOfLab(model, type)->run(stored.data(), 1, &linear);
    const auto at = [&](std::size_t i) { return double(linear[i]); };
    const Imath::V3d rgb(at(0), at(1), at(2));
    return labFromXYZ(XYZ(rgb * xyzFromRGB(*findColorSpace("lin_prophoto"), kD50)), kD50);
}

/// Linear colours are floats: 2^-24 of each, by the slope of Lab, 903.3 at black for L and 3894 for
/// a and b, whose matrix adds up to twice that.
constexpr double kFloat = 2 * 3894 * 0x1p-24;

void check(const Lab& a, const Lab& b) {
    CHECK(std::abs(a.L - b.L) < kFloat);
    CHECK(std::abs(a.a - b.a) < kFloat);
    CHECK(std::abs(a.b - b.b) < kFloat);
}

}  // namespace

TEST_CASE("Lab as TIFF 6.0 and as Adobe's notes of 2002 store it, in 8 and 16 bits") {
    std::mt19937 random(1);
    const auto below = [&](int end) { return std::uniform_int_distribution(0, end - 1)(random); };
    for (int i = 0; i < 2000; ++i) {
        const double L = below(256);
        const double a = below(200) - 100;
        const double b = below(200) - 100;
        const auto share = [](double code, double most) { return float(code / most); };
        const auto wrapped = [](double v, double range) { return v < 0 ? v + range : v; };
        check(decoded(ColorModel::cieLab, TexelType::uint8,
                      {share(L, 255), share(wrapped(a, 256), 255), share(wrapped(b, 256), 255)}),
              {L * 100 / 255, a, b});
        check(decoded(ColorModel::iccLab, TexelType::uint8,
                      {share(L, 255), share(a + 128, 255), share(b + 128, 255)}),
              {L * 100 / 255, a, b});
        check(decoded(ColorModel::cieLab, TexelType::uint16,
                      {share(L * 257, 65535), share(wrapped(a * 256, 65536), 65535),
                       share(wrapped(b * 256, 65536), 65535)}),
              {L * 100 / 255, a, b});
        check(decoded(ColorModel::iccLab, TexelType::uint16,
                      {share(L * 256, 65535), share((a + 128) * 256, 65535),
                       share((b + 128) * 256, 65535)}),
              {L * 100 / 255, a, b});
    }
}

TEST_CASE("Lab's white is (1, 1, 1), its black (0, 0, 0)") {
    std::array<float, 3> linear{};
    const std::array<float, 3> white = {1, 0, 0};
    const auto transform = transformOfLab(ColorModel::cieLab, TexelType::uint8);
    transform->run(white.data(), 1, &linear);
    for (const float c : linear) CHECK(std::abs(c - 1) < 1e-6F);
    const std::array<float, 3> black{};
    transform->run(black.data(), 1, &linear);
    for (const float c : linear) CHECK(std::abs(c) < 1e-6F);
}

TEST_CASE("inks without a profile: the product of what each leaves, encoded") {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(0, 1);
    const auto inks = transformOfInks(ColorModel::cmyk, Transfer::sRGB);
    const auto left = transformOfInks(ColorModel::cmykOnPaper, Transfer::sRGB);
    for (int i = 0; i < 1000; ++i) {
        const std::array<float, 4> cmyk = {uniform(random), uniform(random), uniform(random),
                                           uniform(random)};
        std::array<float, 3> linear{};
        inks->run(cmyk.data(), 1, &linear);
        for (std::size_t c = 0; c < 3; ++c) {
            const double encoded = (1 - double(cmyk[c])) * (1 - double(cmyk[3]));
            // Floats inside and out, by the largest slope of the curve, 2.4 at 1.
            CHECK(std::abs(double(linear[c]) - linearFromSRGB(encoded)) < 4 * 2.4 * 0x1p-24);
        }
        const std::array<float, 4> paper = {1 - cmyk[0], 1 - cmyk[1], 1 - cmyk[2], 1 - cmyk[3]};
        std::array<float, 3> same{};
        left->run(paper.data(), 1, &same);
        for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(same[c] - linear[c]) < 1e-6F);
    }
}
