#include "methods/published/jakob2019_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace specbake;
using namespace specbake::bench;

namespace {

double miss(const Method& method, const XYZ& color, const Spectrum& s) {
    const Imath::V3d d = method.frame().observer.color(s) - color;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

}  // namespace

TEST_CASE("Jakob & Hanika: a spectrum of their family is found again from its colour") {
    const Frame frame = sRGBFrame();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (int i = 0; i < 300; ++i) {
        const double a = uniform(random), b = uniform(random), c = uniform(random);
        const SigmoidCoefficients made{a, b, c};
        const XYZ color = frame.observer.color(sigmoidSpectrum(made));
        const SigmoidFit fit = fitSigmoid(color, frame.observer);
        CHECK(fit.labError < 1e-6);
    }
}

TEST_CASE("Jakob & Hanika: sigmoid and polynomial as printed") {
    const Spectrum s = sigmoidSpectrum({0, 0, 0});
    CHECK(maxDifference(s, constantSpectrum(0.5)) == 0);
    const Spectrum t = sigmoidSpectrum({4, -4, 1});  // (2u - 1)²: 1 at both ends, 0 in the middle
    CHECK(t[0] == doctest::Approx(0.5 + 0.5 / std::sqrt(2.0)).epsilon(1e-15));
    CHECK(t[80] == doctest::Approx(t[0]).epsilon(1e-15));
    CHECK(t[40] == doctest::Approx(0.5).epsilon(1e-15));
}

TEST_CASE("Jakob & Hanika, direct: within 1e-3 of XYZ inside sRGB, bounded") {
    const Jakob2019Direct method(sRGBFrame());
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const double r = uniform(random), g = uniform(random), b = uniform(random);
        const XYZ color = method.frame().xyz(RGB(r, g, b));
        const Spectrum s = method.reconstruct(color).spectrum;
        CHECK(miss(method, color, s) < 1e-3);
        CHECK(boundsViolation(s) == 0);
    }
}

TEST_CASE("Jakob & Hanika, table: exact at nodes, nearer between them with more of them") {
    double worst[2] = {0, 0};
    for (const int refinement : {0, 1}) {
        const int n = refinement == 0 ? 9 : 17;
        Jakob2019Table method(sRGBFrame(), n);
        method.setUp();
        const RGB node = method.nodeColor(1, n / 2, n / 4, n / 2);
        const XYZ nodeXYZ = method.frame().xyz(node);
        // coefficients of order 10 rounded to float move the spectrum by 10 * 2^-24
        CHECK(miss(method, nodeXYZ, method.reconstruct(nodeXYZ).spectrum) < 1e-5);
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> uniform(0.05, 0.95);
        for (int i = 0; i < 500; ++i) {
            const double r = uniform(random), g = uniform(random), b = uniform(random);
            const XYZ color = method.frame().xyz(RGB(r, g, b));
            worst[refinement] = std::max(worst[refinement],
                                         miss(method, color, method.reconstruct(color).spectrum));
        }
    }
    CHECK(worst[1] < worst[0] / 3);  // trilinear: a quarter, where the fits are smooth
}

TEST_CASE("Jakob & Hanika, table: the texel path agrees with the double path, black included") {
    Jakob2019Table method(sRGBFrame(), 8);
    method.setUp();
    const std::vector<Imath::V3f> texels{{0, 0, 0},       {1, 1, 1},          {1, 0, 0},
                                         {0.2F, 0.5F, 1}, {0.3F, 0.3F, 0.3F}, {0.9F, 0.1F, 0.4F},
                                         {2, -1, 0.5F}};
    std::vector<float> spectra(texels.size() * kBandCount);
    method.reconstructTexels(texels, spectra);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const RGB rgb(texels[i].x, texels[i].y, texels[i].z);
        const Spectrum s = method.reconstruct(method.frame().xyz(rgb)).spectrum;
        for (std::size_t m = 0; m < s.size(); ++m) {
            CAPTURE(i);
            // x is at most 200 and rounded to 24 bits a few times; S' <= ½
            CHECK(std::abs(double(spectra[i * kBandCount + m]) - s[m]) < 200 * 8 * 0x1p-24);
        }
    }
}
