#include "solid/generators.h"
#include "support/solid_samples.h"

#include <specbake/core/solid.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

const std::array<std::string, 4> kLights = {"D65", "E", "A", "F11"};

std::vector<Imath::V3d> generatorVectors(const Observer& observer) {
    std::vector<Imath::V3d> vectors;
    for (const auto& bands : generatorsOf(observer)->bands) {
        Imath::V3d sum(0.0);
        for (const int band : bands) sum += observer.weights()[std::size_t(band)];
        vectors.push_back(sum);
    }
    return vectors;
}

/// The steepest that the spectrum of a boundary colour can be: on the parallelogram of w_m and w_k
/// the value s_k goes from 0 to 1 over its height |w_m × w_k| / |w_m|. The bases, where spectra are
/// chosen, are less steep.
double steepestSpectrum(const Observer& observer) {
    const std::vector<Imath::V3d> w = generatorVectors(observer);
    double steepest = 0;
    const auto generators = generatorsOf(observer);
    for (const SidePair& side : generators->sides) {
        const Imath::V3d& a = w[std::size_t(side.first)];
        const Imath::V3d& b = w[std::size_t(side.second)];
        steepest = std::max(steepest, std::max(a.length(), b.length()) / a.cross(b).length());
    }
    return steepest;
}

double largestDifference(const Spectrum& a, const Spectrum& b, std::size_t first, std::size_t end) {
    double largest = 0;
    for (std::size_t m = first; m < end; ++m) largest = std::max(largest, std::abs(a[m] - b[m]));
    return largest;
}

}  // namespace

TEST_CASE("nearest spectra are continuous, as steep as the table's narrowest face at the most") {
    constexpr std::size_t at400 = 4;
    constexpr std::size_t at700 = 64;
    for (const std::string& light : kLights) {
        CAPTURE(light);
        const Observer observer(light);
        const Solid solid(observer);
        const double steepest = steepestSpectrum(observer);
        Random random(61);
        double visible = 0;
        double far = 0;
        for (int i = 0; i < 10000; ++i) {
            // Steps that the narrowest faces, some 1e-7 wide, show, and smaller ones, which do not
            // cross them.
            const double step = std::pow(10.0, random(-11, -6));
            const XYZ a(random.onBoundary(observer, solid) + random.direction() * 0.05);
            const XYZ b(a + random.direction() * step);
            const Solid::Nearest p = solid.nearest(a);
            const Solid::Nearest q = solid.nearest(b);
            if (!p.spectrum || !q.spectrum) continue;
            // The nearest point of a convex set moves by no more than what it is nearest to; both
            // are so to rounding.
            const double apart = (p.color - q.color).length();
            const double rounding = 2 * sumRounding(solid);
            CHECK(apart <= step * (1 + 1e-9) + rounding);
            const double all = largestDifference(*p.spectrum, *q.spectrum, 0, kBandCount);
            REQUIRE(all <= steepest * (apart + rounding));
            visible =
                std::max(visible, largestDifference(*p.spectrum, *q.spectrum, at400, at700) / step);
            far = std::max(far,
                           largestDifference(*p.spectrum, *q.spectrum, at700, kBandCount) / step);
        }
        MESSAGE(light, ": slope 400-700 nm ", visible, ", from 700 nm ", far, ", bound ", steepest);
    }
}
