#include "support/brute_solid.h"
#include "support/solid_samples.h"

#include <specbake/core/solid.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace specbake;
using namespace specbake::testing;

namespace {

/// How much colour the difference of two spectra moves, band by band: a difference where the eye is
/// all but blind (1e-7 of the luminance at 780 nm) counts for as little.
double weightedDifference(const Observer& observer, const Spectrum& a, const Spectrum& b) {
    double largest = 0;
    for (std::size_t m = 0; m < a.size(); ++m) {
        largest = std::max(largest, std::abs(a[m] - b[m]) * observer.weights()[m].length());
    }
    return largest;
}

}  // namespace

TEST_CASE("all faces are parallelograms: no third generator in the plane of a pair") {
    const BruteSolid brute(Observer("E"));
    CHECK(brute.faceCount() == 5454);
    CHECK(brute.coplanarTriples() == 0);
}

TEST_CASE("the gauge agrees with brute force over all pairs") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        const BruteSolid brute(observer);
        Random random(1);
        double worst = 0;
        for (int i = 0; i < 10000; ++i) {
            const XYZ t = random.inBox(solid, 0.5);
            const double expected = brute.gauge(t);
            worst = std::max(worst, std::abs(solid.gauge(t) - expected) / std::max(1.0, expected));
        }
        CHECK(worst <= 2 * solid.gaugeError());  // either has the same bound
    }
}

TEST_CASE("the gauge of black and white is 1, of the centre 0, and grows linearly") {
    for (const std::string& name : illuminantNames()) {
        const Solid solid{Observer(name)};
        CHECK(solid.gaugeError() < 1e-13);
        CHECK(std::abs(solid.gauge(XYZ(0, 0, 0)) - 1) <= solid.gaugeError());
        CHECK(std::abs(solid.gauge(solid.white()) - 1) <= solid.gaugeError());
        CHECK(solid.gauge(solid.center()) == 0);
        CHECK(solid.boundary(solid.center()).spectrum == constantSpectrum(0.5));
        Random random(2);
        for (int i = 0; i < 1000; ++i) {
            const Imath::V3d d = random.direction();
            const double r = solid.gauge(XYZ(solid.center() + d));
            for (const double scale : {1e-6, 0.5, 3.0, 1e6}) {
                const double scaled = solid.gauge(XYZ(solid.center() + d * scale));
                CHECK(std::abs(scaled - r * scale) <=
                      2 * solid.gaugeError() * std::max(1.0, r * scale));
            }
        }
    }
}

TEST_CASE("a convex mixture of spectra is inside; its gauge is at most 1") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        Spectrum s;
        const double coin = random(0, 1);
        for (double& v : s) v = random(0, 1) < coin ? std::round(random(0, 1)) : random(0, 1);
        CHECK(solid.gauge(observer.color(s)) <= 1 + solid.gaugeError());
    }
}

TEST_CASE("a boundary colour's spectrum has that colour and is bounded") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        Random random(4);
        for (int i = 0; i < 2000; ++i) {
            const Solid::Boundary exit = solid.boundary(random.onBoundary(observer, solid));
            CHECK(withinBounds(exit.spectrum));
            CHECK(std::abs(exit.gauge - 1) <= solid.gaugeError());
            CHECK((observer.color(exit.spectrum) - exit.color).length() <=
                  solid.gaugeError() * solid.white().length() + sumRounding(solid));
        }
    }
}

TEST_CASE("a boundary spectrum has at most two changing generators, or is a base's") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(5);
    int onBase = 0;
    for (int i = 0; i < 5000; ++i) {
        const Solid::Boundary exit = solid.boundary(random.onBoundary(observer, solid));
        const Spectrum& s = exit.spectrum;
        CHECK(s[70] == s[74]);  // 730 and 750 nm
        CHECK(s[75] == s[77]);  // 755 and 765 nm
        CHECK(s[75] == s[79]);  // and 775 nm
        const auto isFree = [](double v) { return v > 0 && v < 1; };
        if (std::abs(exit.color.z - solid.center().z) >= solid.center().z * (1 - 1e-14)) {
            ++onBase;
            CHECK(std::none_of(s.begin(), s.begin() + 54, isFree));  // below 650 nm, Z > 0
        } else {
            // Members of a merged group count once.
            CHECK(std::count_if(s.begin(), s.end(), isFree) - (isFree(s[70]) + 2 * isFree(s[75])) <=
                  2);
        }
    }
    CHECK(onBase > 100);
}

TEST_CASE("boundary spectra are those of the opposite point, turned over") {
    const Observer observer("D65");
    const Solid solid(observer);
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        const XYZ t = random.onBoundary(observer, solid);
        Spectrum turned = solid.boundary(XYZ(solid.white() - t)).spectrum;
        for (double& v : turned) v = 1 - v;
        // s of a face is rounding / (length times sine): weighted by the length, 1/sine remains,
        // below 1e4 for neighbouring bands.
        CHECK(weightedDifference(observer, solid.boundary(t).spectrum, turned) <
              1e4 * solid.gaugeError());
    }
}

TEST_CASE("the boundary spectrum is continuous over sides, bases and their rims") {
    for (const char* name : {"D65", "A", "F11"}) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        Random random(7);
        double worst = 0;
        for (int i = 0; i < 120; ++i) {
            // Halve a segment 40 times, each time keeping the half over which the spectrum changes
            // more: a jump would stay.
            XYZ a = random.onBoundary(observer, solid);
            XYZ b = i % 2 ? random.onBoundary(observer, solid) : XYZ(a + random.direction() * 0.01);
            for (int halving = 0; halving < 40; ++halving) {
                const XYZ middle((a + b) / 2);
                const Spectrum s = solid.boundary(middle).spectrum;
                const double before = weightedDifference(observer, solid.boundary(a).spectrum, s);
                const double after = weightedDifference(observer, s, solid.boundary(b).spectrum);
                (before > after ? b : a) = middle;
            }
            worst = std::max(worst, weightedDifference(observer, solid.boundary(a).spectrum,
                                                       solid.boundary(b).spectrum));
        }
        CHECK(worst < 1e-6);
    }
}
