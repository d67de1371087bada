#include "solve/natural/natural.h"

#include "solve/shell.h"
#include "support/solid_samples.h"

#include <specbake/core/color_space.h>
#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

/// An observer and the two solvers for it.
struct Bench {
    explicit Bench(const std::string& light)
        : observer(light),
          smooth(std::make_shared<const ShellSolver>(observer)),
          natural(observer, smooth) {}

    const Solid& solid() const { return smooth->solid(); }
    XYZ atGauge(Random& random, double gauge) const {
        const XYZ boundary = random.onBoundary(observer, solid());
        return XYZ(solid().center() + (boundary - solid().center()) * gauge);
    }

    Observer observer;
    std::shared_ptr<const ShellSolver> smooth;
    NaturalSolver natural;
};

/// Bounded, and as exact as the smooth solution (2e-12, shell_test.cpp) and the samples' (each
/// 1e-12 of its colour, below 1.2) together, and four 81-term sums.
void checkExact(const Bench& bench, const XYZ& color) {
    const Solution solution = bench.natural.solve(color);
    CAPTURE(color);
    REQUIRE(solution.solved());
    REQUIRE(withinBounds(solution.spectrum));
    const double residual = largestComponent(bench.observer.color(solution.spectrum) - color);
    REQUIRE(residual <= 4e-12 + 4 * sumRounding(bench.solid()));
    REQUIRE(std::abs(solution.report.residual - residual) <= 2 * sumRounding(bench.solid()));
}

RGB inCube(Random& random, double top) {
    return {random(0, top), random(0, top), random(0, top)};
}

}  // namespace

TEST_CASE("every colour of the solid is exact and bounded: over 20,000, under six lights") {
    for (const char* light : {"D65", "A", "F11", "E", "D60", "F2"}) {
        CAPTURE(light);
        const Bench bench(light);
        const auto matrix = xyzFromRGB(*findColorSpace("lin_rec709"), bench.observer.white());
        Random random(41);
        for (int i = 0; i < 1000; ++i) {
            const XYZ inSRGB(inCube(random, 1) * matrix);  // not all of it is F2's
            if (bench.solid().contains(inSRGB)) checkExact(bench, inSRGB);
            if (bench.solid().contains(inSRGB)) checkExact(bench, XYZ(inSRGB * random(0, 0.02)));
            checkExact(bench, bench.atGauge(random, 1 - std::pow(10.0, random(-7, 0))));
            const double scale = std::pow(10.0, random(-12, 0));
            checkExact(bench, XYZ(bench.atGauge(random, random(0.5, 1)) * scale));
        }
    }
}

TEST_CASE("on the boundary and outside it is the base's answer") {
    const Bench bench("D65");
    Random random(42);
    for (int i = 0; i < 2000; ++i) {
        const XYZ outside = bench.atGauge(random, random(1.001, 2));
        const Solution answer = bench.natural.solve(outside);
        CHECK(answer.report.status == SolveReport::Status::outside);
        CHECK(answer.spectrum == bench.smooth->solve(outside).spectrum);
        // The two free bands of (13) and those parallel to them may be within the bounds.
        const XYZ rim = bench.atGauge(random, 1);
        CHECK(maxDifference(bench.natural.solve(rim).spectrum, bench.smooth->solve(rim).spectrum) <=
              1e-9);
    }
    CHECK(!bench.natural.solve(XYZ(std::nan(""), 0, 0)).solved());
    CHECK(!bench.natural.solve(XYZ(0, HUGE_VAL, 0)).solved());
}

TEST_CASE("white is 1, black 0, greys are flat, under every light") {
    for (const std::string& light : illuminantNames()) {
        CAPTURE(light);
        const Bench bench(light);
        CHECK(bench.natural.solve(bench.observer.white()).spectrum == constantSpectrum(1));
        CHECK(bench.natural.solve(XYZ(0, 0, 0)).spectrum == constantSpectrum(0));
        for (const double grey : {1e-12, 1e-6, 0.01, 0.18, 0.5, 0.9, 0.99, 1 - 1e-9}) {
            const Spectrum s = bench.natural.solve(XYZ(bench.observer.white() * grey)).spectrum;
            // Chroma is rounding, about 1e-13 of the 2 at which the fade is a half.
            CHECK(maxDifference(s, constantSpectrum(grey)) <= 81 * 0x1p-52 * grey + 1e-24);
        }
    }
}

TEST_CASE("halving a segment towards its greater change ends at no jump") {
    for (const char* light : {"D65", "F11"}) {
        CAPTURE(light);
        const Bench bench(light);
        Random random(43);
        const auto spectrum = [&](const XYZ& t) { return bench.natural.solve(t).spectrum; };
        for (int i = 0; i < 600; ++i) {
            XYZ a = bench.atGauge(random, random(0, 0.98));
            XYZ b = i % 2 == 0 ? bench.atGauge(random, random(0, 0.98))
                               : XYZ(a * random(0.9, 1.0));  // towards black
            Spectrum atA = spectrum(a);
            Spectrum atB = spectrum(b);
            while ((b - a).length() > 1e-9) {
                const XYZ middle((a + b) * 0.5);
                const Spectrum between = spectrum(middle);
                const bool first = maxDifference(atA, between) > maxDifference(between, atB);
                (first ? b : a) = middle;
                (first ? atB : atA) = between;
            }
            // Twice the steepest slope that was met, 38; solutions differ by their tolerance too,
            // 1e-12 times a slope.
            CHECK(maxDifference(atA, atB) <= 2 * 38 * 1e-9 + 1e-10);
        }
    }
}

TEST_CASE("slopes over the sRGB cube: 99.9 % of 20,000 pairs are at most 12, none above 40") {
    const Bench bench("D65");
    const auto matrix = xyzFromRGB(*findColorSpace("lin_rec709"), bench.observer.white());
    Random random(44);
    std::vector<double> slopes;
    while (slopes.size() < 20'000) {
        const RGB a = inCube(random, 1);
        const RGB b(a + random.direction() * 1e-4);
        if (std::min({b.x, b.y, b.z}) < 0 || std::max({b.x, b.y, b.z}) > 1) continue;
        slopes.push_back(maxDifference(bench.natural.solve(XYZ(a * matrix)).spectrum,
                                       bench.natural.solve(XYZ(b * matrix)).spectrum) /
                         (a - b).length());
    }
    std::sort(slopes.begin(), slopes.end());
    CHECK(slopes[slopes.size() * 999 / 1000] <= 12);
    CHECK(slopes.back() <= 40);
}

TEST_CASE("a move is whole where there is room, and ends at the first bound where there is not") {
    Spectrum s = constantSpectrum(0.5);
    Spectrum v = constantSpectrum(0);
    v[3] = 0.25;
    v[7] = -0.375;
    const Spectrum whole = movedWithinBounds(s, v);
    CHECK(whole[3] == 0.75);
    CHECK(whole[7] == 0.125);
    CHECK(whole[0] == 0.5);
    v[3] = 2;  // four times the room above
    const Spectrum part = movedWithinBounds(s, v);
    CHECK(part[3] == 1);
    CHECK(part[7] == 0.5 - 0.375 / 4);
    s[7] = 0;  // no room below
    CHECK(movedWithinBounds(s, v) == s);
}
