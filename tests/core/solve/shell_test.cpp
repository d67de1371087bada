#include "solve/shell.h"

#include "support/solid_samples.h"

#include <specbake/core/color_space.h>
#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

double largest(const Imath::V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Solved, exact and bounded, or the test stops.
SolveReport solveExactly(const ShellSolver& solver, const Observer& observer, const XYZ& color) {
    const Solution solution = solver.solve(color);
    CAPTURE(color);
    REQUIRE(solution.solved());
    REQUIRE(withinBounds(solution.spectrum));
    // The smooth solver stops at 1e-12 of the colour, below 1.2 here; colours and sums round.
    const double residual = largest(observer.color(solution.spectrum) - color);
    REQUIRE(residual <= 2e-12);
    REQUIRE(std::abs(solution.report.residual - residual) <= 2 * sumRounding(solver.solid()));
    return solution.report;
}

XYZ atGauge(Random& random, const Solid& solid, double gauge) {
    const Imath::V3d d = random.direction();
    return XYZ(solid.center() + d * (gauge / solid.gauge(XYZ(solid.center() + d))));
}

/// 1 over a few bands, at the ends over parts of them, and 0 elsewhere; or the opposite.
Spectrum narrowBand(Random& random) {
    const double first = random(0, kBandCount);
    const double last = first + std::pow(10.0, random(-2, 1));
    const bool opposite = random(0, 1) < 0.5;
    Spectrum s;
    for (int m = 0; m < kBandCount; ++m) {
        const double part =
            std::clamp(std::min(last, m + 1.0) - std::max(first, 1.0 * m), 0.0, 1.0);
        s[std::size_t(m)] = opposite ? 1 - part : part;
    }
    return s;
}

/// A random colour of the cube [0, 1]^3 with `fixed` of its components at 0 or 1.
RGB inCube(Random& random, int fixed) {
    RGB rgb(random(0, 1), random(0, 1), random(0, 1));
    const int first = int(random(0, 3));
    for (int i = 0; i < fixed; ++i) rgb[(first + i) % 3] = std::round(random(0, 1));
    return rgb;
}

}  // namespace

TEST_CASE("every colour of the solid is solved, under every illuminant") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const ShellSolver solver(observer);
        Random random(21);
        for (int i = 0; i < 3000; ++i) {
            const XYZ t = random.inBox(solver.solid(), 0);
            if (solver.solid().gauge(t) <= 1) solveExactly(solver, observer, t);
        }
    }
}

TEST_CASE("the layer under the boundary and the boundary itself are solved") {
    for (const char* name : {"D65", "A", "F11"}) {
        CAPTURE(name);
        const Observer observer(name);
        const ShellSolver solver(observer);
        Random random(22);
        for (const double gauge : {0.9, 0.99, 0.999, 0.9999, 0.99999, 0.999999, 1.0}) {
            for (int i = 0; i < 100; ++i) {
                solveExactly(solver, observer, atGauge(random, solver.solid(), gauge));
                const XYZ rim = random.inBase(observer);
                const Imath::V3d fromCenter = rim - solver.solid().center();
                solveExactly(solver, observer, XYZ(solver.solid().center() + fromCenter * gauge));
            }
        }
    }
}

TEST_CASE("dark colours down to black are solved") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    Random random(23);
    for (int i = 0; i < 4000; ++i) {
        Spectrum s;
        const double scale = std::pow(10.0, random(-12, 0));
        for (double& v : s) v = scale * std::pow(random(0, 1), 8);
        solveExactly(solver, observer, observer.color(s));
    }
}

TEST_CASE("sRGB never meets the layer, on its faces, edges and corners, however dark") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    const Imath::M33d matrix = xyzFromRGB(*findColorSpace("srgb"), observer.white());
    Random random(24);
    for (int i = 0; i < 3000; ++i) {
        const double scale = i % 2 ? 1 : std::pow(10.0, random(-6, 0));
        const XYZ t(RGB(inCube(random, i % 4) * scale) * matrix);
        CHECK(!solveExactly(solver, observer, t).blended);
    }
}

TEST_CASE("wide gamuts: what is inside is solved, what is outside is said to be") {
    for (const char* name : {"lin_rec2020", "acescg", "lin_prophoto"}) {
        CAPTURE(name);
        const ColorSpace& space = *findColorSpace(name);
        const Observer observer(space.illuminant);
        const ShellSolver solver(observer);
        const Imath::M33d matrix = xyzFromRGB(space, observer.white());
        Random random(25);
        int outside = 0;
        for (int i = 0; i < 2000; ++i) {
            const XYZ t(inCube(random, i % 3) * matrix);
            if (solver.solid().gauge(t) <= 1) {
                solveExactly(solver, observer, t);
            } else {
                ++outside;
                const Solution solution = solver.solve(t);
                CHECK(solution.report.status == SolveReport::Status::outside);
                CHECK(withinBounds(solution.spectrum));
            }
        }
        CHECK(outside > 100);
    }
}

TEST_CASE("white, black and greys are flat, white however a colour space rounds it") {
    for (const ColorSpace& space : colorSpaces()) {
        CAPTURE(space.name);
        const Observer observer(space.illuminant);
        const ShellSolver solver(observer);
        const XYZ white = space.isXYZ() ? observer.white()
                                        : XYZ(RGB(1, 1, 1) * xyzFromRGB(space, observer.white()));
        CHECK(solver.solve(white).spectrum == constantSpectrum(1));
        CHECK(solver.solve(XYZ(0, 0, 0)).spectrum == constantSpectrum(0));
        for (const double grey : {1e-12, 1e-6, 0.01, 0.18, 0.5, 0.99, 1 - 1e-9}) {
            const Spectrum s = solver.solve(XYZ(white * grey)).spectrum;
            // Y of white is 1 to 81 roundings.
            CHECK(maxDifference(s, constantSpectrum(grey)) <= 81 * 0x1p-52 * grey);
        }
    }
}

TEST_CASE("colours that rounding puts outside are solved, those beyond are not") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    const Solid& solid = solver.solid();
    Random random(26);
    for (int i = 0; i < 1000; ++i) {
        const double rounding = solid.gaugeError();
        solveExactly(solver, observer, atGauge(random, solid, 1 + 2 * rounding));
        CHECK(solver.solve(atGauge(random, solid, 1 + 8 * rounding)).report.status ==
              SolveReport::Status::outside);
    }
    CHECK(!solver.solve(XYZ(std::nan(""), 0, 0)).solved());
    CHECK(!solver.solve(XYZ(0, HUGE_VAL, 0)).solved());
}

TEST_CASE("the layer joins the smooth solution above it and the boundary spectrum below") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    const Solid& solid = solver.solid();
    Random random(27);
    for (int i = 0; i < 300; ++i) {
        const XYZ boundary = random.onBoundary(observer, solid);
        const double depth = solver.depth(boundary);
        if (depth < 1e-6) continue;
        const auto at = [&](double below) {
            const Imath::V3d fromCenter = boundary - solid.center();
            return solver.solve(XYZ(solid.center() + fromCenter * (1 - below)));
        };
        const double step = 1e-6;
        const Solution above = at(depth * (1 + step));
        const Solution inside = at(depth * (1 - step));
        CHECK(!above.report.blended);
        CHECK(inside.report.blended);
        // Across the layer the spectrum changes by 1 at the most, so by `step` here; above it, as
        // the smooth solution does: less than 100 times the relative depth.
        CHECK(maxDifference(above.spectrum, inside.spectrum) <= 101 * step);
        CHECK(maxDifference(at(depth * step).spectrum, solid.boundary(boundary).spectrum) <=
              2 * step + 1e-6);
    }
}

TEST_CASE("where Newton fails below the layer, a deeper colour of the ray takes its place") {
    const Observer observer("F11");
    const ShellSolver solver(observer, 1e-10);
    const SmoothSolver smooth(observer);
    Random random(29);
    int failures = 0;
    for (int i = 0; i < 150; ++i) {
        const XYZ boundary = observer.color(narrowBand(random));
        const XYZ t(solver.solid().center() + (boundary - solver.solid().center()) * (1 - 1e-9));
        if (smooth.solve(t).solved()) continue;
        ++failures;
        const SolveReport report = solveExactly(solver, observer, t);
        CHECK(report.blended);
    }
    CHECK(failures > 0);
    CHECK_THROWS_AS(ShellSolver(observer, 0), ArgumentError);
    CHECK_THROWS_AS(ShellSolver(observer, 1.5), ArgumentError);
}

TEST_CASE("near colours get near spectra in the sRGB cube") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    const Imath::M33d matrix = xyzFromRGB(*findColorSpace("srgb"), observer.white());
    Random random(28);
    std::vector<double> slopes;
    for (int i = 0; i < 5000; ++i) {
        const RGB a = inCube(random, 0);
        const RGB b(a + random.direction() * 1e-4);
        const auto inUnit = [](double v) { return v >= 0 && v <= 1; };
        if (!inUnit(b.x) || !inUnit(b.y) || !inUnit(b.z)) continue;
        slopes.push_back(maxDifference(solver.solve(XYZ(a * matrix)).spectrum,
                                       solver.solve(XYZ(b * matrix)).spectrum) /
                         (a - b).length());
    }
    std::sort(slopes.begin(), slopes.end());
    CHECK(slopes.back() <= 12);
    CHECK(slopes[slopes.size() * 999 / 1000] <= 4);
}
