#include "solve/shell.h"
#include "support/solid_samples.h"

#include <specbake/core/outside.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

const std::array<std::string, 4> kLights = {"D65", "E", "A", "F11"};
constexpr double kMerged = 1e-6;  ///< distance of chromaticities

/// Outward normals of the cone's face planes: of every two bands' chromaticities that have all
/// others on one side, but for rounding. By brute force and in doubles, where the library has
/// integers. The bands from 700 nm on, which have one chromaticity to 1e-6, make no planes among
/// themselves.
std::vector<Imath::V3d> coneNormals(const Observer& observer) {
    std::vector<Imath::V3d> points;
    for (const Imath::V3d& w : observer.weights()) points.push_back(w / (w.x + w.y + w.z));
    std::vector<Imath::V3d> normals;
    for (const Imath::V3d& a : points) {
        for (const Imath::V3d& b : points) {
            if ((a - b).length() < kMerged) continue;
            const Imath::V3d n = a.cross(b).normalized();
            const bool outward = std::all_of(points.begin(), points.end(),
                                             [&](const auto& p) { return n.dot(p) < 1e-12; });
            if (outward) normals.push_back(n);
        }
    }
    return normals;
}

double depthBelow(const std::vector<Imath::V3d>& cone, const XYZ& t) {
    double depth = std::numeric_limits<double>::infinity();
    for (const Imath::V3d& n : cone) depth = std::min(depth, -n.dot(t));
    return depth / t.length();
}

/// A direction in one of the cone's faces, near enough: between two neighbouring bands, or purple.
Imath::V3d alongEdge(const Observer& observer, Random& random) {
    const auto m = std::size_t(random(0, kBandCount));
    const auto next = (m + 1) % kBandCount;
    const double share = random(0, 1);
    return (observer.weights()[m].normalized() * share +
            observer.weights()[next].normalized() * (1 - share))
        .normalized();
}

/// By bisection: the largest k in (0, 1) for which k·color lies in the solid.
double largestScale(const Solid& solid, const XYZ& color) {
    double inside = 0;
    double outside = 1;
    while (true) {
        const double middle = 0.5 * (inside + outside);
        if (middle <= inside || middle >= outside) return inside;
        (solid.contains(XYZ(color * middle)) ? inside : outside) = middle;
    }
}

}  // namespace

TEST_CASE("every rule leaves colours of the solid alone") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    Random random(31);
    for (int i = 0; i < 1000; ++i) {
        const XYZ t = random.inBox(solver.solid(), 0);
        if (solver.solid().gauge(t) > 1) continue;
        for (const Outside rule : {Outside::nearest, Outside::scale, Outside::error}) {
            const Attainable given = attainable(solver.solid(), t, rule);
            CHECK(!given.outside);
            CHECK(given.color == t);
        }
    }
}

TEST_CASE("scale gives the brightest colour of the same chromaticity, in its rim a mixture") {
    for (const std::string& light : kLights) {
        CAPTURE(light);
        const Observer observer(light);
        const Solid solid(observer);
        const std::vector<Imath::V3d> cone = coneNormals(observer);
        Random random(32);
        std::array<int, 3> met{};  // in the cone, in its rim, outside
        for (int i = 0; i < 5000; ++i) {
            const XYZ t = i % 2 ? XYZ(random.inBox(solid, 0) * 3)
                                : XYZ(alongEdge(observer, random) + random.direction() * 0.02);
            if (solid.contains(t)) continue;
            const double depth = depthBelow(cone, t);
            const double found = solid.depthInCone(t);
            CHECK((depth > 0 ? std::abs(found - depth) : std::max(0.0, found)) <= kMerged);
            const Attainable given = attainable(solid, t, Outside::scale);
            REQUIRE(given.outside);
            CHECK(solid.contains(given.color));
            const XYZ nearest = solid.nearest(t).color;
            if (found <= 0) {
                ++met[2];
                CHECK(given.color == nearest);
                continue;
            }
            const double k = largestScale(solid, t);
            const Imath::V3d brightest = t * k;
            // A little brighter is outside, by more than the gauge's own rounding.
            CHECK(solid.gauge(XYZ(t * (k * (1 + 1e-9)))) > 1);
            const double share = std::clamp(found * 32, 0.0, 1.0);
            const Imath::V3d expected = brightest * share + nearest * (1 - share);
            CHECK((given.color - expected).length() <= 1e-9);
            ++met[share < 1 ? 1 : 0];
        }
        for (const int count : met) CHECK(count > 300);
    }
}

TEST_CASE("scale has no jump where the chromaticity leaves the cone: 10^5 pairs") {
    // Within the rim the colour goes from S to N over δ = 1/32, and |S − N| is below |white| < 2:
    // with the slopes of S itself, which (1 − β) damps, 64 is not reached where it was measured.
    // The old rule jumped: a slope of 10^7 at this step.
    constexpr double step = 1e-7;
    constexpr double steepest = 64;
    for (const std::string& light : kLights) {
        CAPTURE(light);
        const Observer observer(light);
        const Solid solid(observer);
        Random random(35);
        double largest = 0;
        for (int i = 0; i < 25000; ++i) {
            const Imath::V3d edge = alongEdge(observer, random) * std::pow(10.0, random(-1.5, 1));
            // Every other pair is at the very edge, the rest at any place of the rim.
            const double off = i % 2 ? 0 : random(-0.05, 0.05) * edge.length();
            const XYZ a(edge + random.direction() * off + random.direction() * step / 2);
            const XYZ b(a + random.direction() * step);
            const XYZ there = attainable(solid, a, Outside::scale).color;
            const XYZ here = attainable(solid, b, Outside::scale).color;
            largest = std::max(largest, (here - there).length() / step);
        }
        CAPTURE(largest);
        CHECK(largest < steepest);
        CHECK(largest > 1);
        MESSAGE(light, ": largest slope ", largest);
    }
}

TEST_CASE("along lines through the cone's edge, scaled colours and spectra follow") {
    const Observer observer("E");
    const ShellSolver solver(observer);
    const ColorResolver resolver(solver.solid(), solver, Outside::scale);
    // The pair that used to be 0.6 apart in Y.
    const XYZ inside(.0854, .8434, .0854);
    const XYZ beyond(.0850, .8440, .0850);
    const XYZ a = resolver.resolve(inside).given;
    const XYZ b = resolver.resolve(beyond).given;
    CHECK((a - b).length() <= 64 * (inside - beyond).length());
    // From one to the other in steps: no step is more than its share of the way by much.
    Spectrum before = resolver.resolve(inside).solution.spectrum;
    constexpr int steps = 2000;
    double largest = 0;
    for (int i = 1; i <= steps; ++i) {
        const XYZ t(inside + (beyond - inside) * (double(i) / steps));
        const Spectrum spectrum = resolver.resolve(t).solution.spectrum;
        largest = std::max(largest, maxDifference(spectrum, before));
        before = spectrum;
    }
    MESSAGE("largest step of a band: ", largest);
    CHECK(largest < 0.05);
}

TEST_CASE("a resolver says what it gave, and every finite colour has an answer") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    Random random(33);
    for (const Outside rule : {Outside::nearest, Outside::scale}) {
        const ColorResolver resolver(solver.solid(), solver, rule);
        for (int i = 0; i < 1000; ++i) {
            const double size = std::pow(10.0, random(-3, 3));
            const XYZ t(random.direction() * size);
            const ColorResolver::Resolved resolved = resolver.resolve(t);
            REQUIRE(resolved.solution.solved());
            CHECK(withinBounds(resolved.solution.spectrum));
            const Imath::V3d miss = observer.color(resolved.solution.spectrum) - resolved.given;
            CHECK(miss.length() < 1e-9);
            CHECK(resolved.outside == !solver.solid().contains(t));
        }
    }
    const ColorResolver refusing(solver.solid(), solver, Outside::error);
    CHECK(refusing.resolve(XYZ(2, 2, 2)).solution.report.status == SolveReport::Status::outside);
}
