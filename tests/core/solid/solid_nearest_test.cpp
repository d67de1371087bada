#include "support/brute_solid.h"
#include "support/solid_samples.h"

#include <specbake/core/solid.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace specbake;
using namespace specbake::testing;

TEST_CASE("the nearest point agrees with brute force over all faces") {
    for (const char* name : {"D65", "A", "F11", "E"}) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        const BruteSolid brute(observer);
        Random random(8);
        int outside = 0;
        for (int i = 0; outside < 5000; ++i) {
            const double reach = std::pow(10.0, random(-9, i % 8 == 0 ? 6 : 1));
            const XYZ t =
                i % 2 ? random.inBox(solid, 0.5)
                      : XYZ(random.onBoundary(observer, solid) + random.direction() * reach);
            if (solid.gauge(t) <= 1 + solid.gaugeError()) continue;
            ++outside;
            const Solid::Nearest nearest = solid.nearest(t);
            XYZ point;
            const double expected = brute.distance(t, &point);
            // Both points are in the solid to rounding, so neither distance is below the true one
            // by more.
            const double rounding = 2 * (sumRounding(solid) + 3 * kUnit * t.length());
            CHECK(std::abs(nearest.distance - expected) <= rounding);
            // The solid is convex: points of it whose distances differ by e are sqrt(2 d e + e^2)
            // apart at the most.
            CHECK((nearest.color - point).length() <=
                  std::sqrt(2 * expected * rounding + rounding * rounding) + rounding);
        }
    }
}

TEST_CASE(
    "the nearest point is optimal, its spectrum bounded and its own, however far the colour") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        const XYZ w = solid.white();
        Random random(9);
        for (int i = 0; i < 4000; ++i) {
            const double reach = std::pow(10.0, random(-9, 6));
            const XYZ t(random.onBoundary(observer, solid) + random.direction() * reach);
            const Solid::Nearest nearest = solid.nearest(t);
            if (!nearest.spectrum) continue;
            CHECK(withinBounds(*nearest.spectrum));
            CHECK((observer.color(*nearest.spectrum) - nearest.color).length() <=
                  sumRounding(solid));
            // (t − p)·(q − p) <= 0 for every q, to rounding. With e = 79u(|t| + w), the rounding of
            // t − W s, the search stops at slopes of e·w_j as it computes them, which are e·w_j
            // from the true ones; here t − p and the support round by as much again. Σ w_j = w.
            const Imath::V3d gap = t - nearest.color;
            double rounding = 0;
            for (int k = 0; k < 3; ++k) {
                rounding += 3 * 81 * kUnit * (std::abs(t[k]) + w[k]) * w[k];
            }
            CHECK(solid.support(gap) - gap.dot(nearest.color) <= rounding);
        }
    }
}

TEST_CASE("the nearest point of a colour inside is itself, of a nearest point the same") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(10);
    for (int i = 0; i < 5000; ++i) {
        const XYZ t = random.inBox(solid, 0.2);
        const Solid::Nearest nearest = solid.nearest(t);
        if (solid.gauge(t) <= 1) {
            CHECK(nearest.color == t);
            CHECK(nearest.distance == 0);
            CHECK(!nearest.spectrum);
        } else {
            CHECK(nearest.distance == (t - nearest.color).length());
            CHECK((solid.nearest(nearest.color).color - nearest.color).length() <=
                  2 * (solid.gaugeError() * solid.white().length() + sumRounding(solid)));
        }
    }
}

TEST_CASE("the nearest points of colours picked by hand") {
    const Observer observer("D65");
    const Solid solid(observer);
    const XYZ w = solid.white();
    // Every w_j has components >= 0, so that 0 and white are nearest to what lies opposite.
    CHECK(solid.nearest(XYZ(-1, -2, -3)).color == XYZ(0, 0, 0));
    CHECK(solid.boundary(XYZ(0, 0, 0)).spectrum == constantSpectrum(0));
    CHECK(solid.boundary(w).spectrum == constantSpectrum(1));
    CHECK(*solid.nearest(XYZ(-1e6, -1e6, -1e6)).spectrum == constantSpectrum(0));
    CHECK(*solid.nearest(XYZ(w * 2)).spectrum == constantSpectrum(1));
    CHECK(*solid.nearest(XYZ(1e6, 1e6, 1e6)).spectrum == constantSpectrum(1));
    // Below the centre of the base at Z = 0 only that component changes.
    XYZ base;
    for (const Imath::V3d& v : observer.weights()) {
        if (v.z == 0) base += v / 2;
    }
    for (const double depth : {1e-9, 1.0, 1e6}) {
        const Solid::Nearest nearest = solid.nearest(XYZ(base.x, base.y, -depth));
        CHECK((nearest.color - base).length() <= sumRounding(solid));
        for (std::size_t m = 0; m < kBandCount; ++m) {
            const double expected = observer.weights()[m].z == 0 ? 0.5 : 0;
            // A base's spectrum changes by at most 1/(2h) for a shift along a normal n.
            CHECK(std::abs((*nearest.spectrum)[m] - expected) < 1e-12);
        }
    }
}
