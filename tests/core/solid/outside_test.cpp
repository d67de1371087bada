#include "solve/shell.h"
#include "support/solid_samples.h"

#include <specbake/core/outside.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

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

TEST_CASE("scale gives the brightest colour of the same chromaticity") {
    const Observer observer("D65");
    const ShellSolver solver(observer);
    const Solid& solid = solver.solid();
    Random random(32);
    int scaled = 0;
    for (int i = 0; i < 1000; ++i) {
        const XYZ t(random.inBox(solid, 0) * 3);
        if (solid.gauge(t) <= 1) continue;
        const Attainable given = attainable(solid, t, Outside::scale);
        REQUIRE(given.outside);
        const double k = given.color.y / t.y;
        const Imath::V3d aside = given.color - t * k;
        if (aside.length() > 1e-12 * t.length()) {  // no such chromaticity: then the nearest colour
            CHECK(solid.gauge(XYZ(t * (1e-5 / t.length()))) >= 1);
            CHECK(given.color == solid.nearest(t).color);
            continue;
        }
        ++scaled;
        CHECK(k < 1);
        CHECK(solid.contains(given.color));
        // A little brighter is outside, by more than the gauge's own rounding.
        CHECK(solid.gauge(XYZ(t * (k * (1 + 1e-9)))) > 1);
    }
    CHECK(scaled > 300);
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
