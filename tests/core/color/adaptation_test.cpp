#include <specbake/core/adaptation.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace specbake;

namespace {

constexpr std::array kKinds = {Adaptation::bradford, Adaptation::cat16};
constexpr double kRounding = 16 * 0x1p-52;  // a few operations on numbers of about 1

double largest(const Imath::V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

TEST_CASE("adaptation takes white to white, for all illuminants") {
    for (const std::string& from : illuminantNames()) {
        for (const std::string& to : illuminantNames()) {
            const XYZ a = Observer(from).white();
            const XYZ b = Observer(to).white();
            for (const Adaptation kind : kKinds) {
                CHECK(largest(a * adaptation(a, b, kind) - b) < kRounding);
            }
        }
    }
}

TEST_CASE("adaptation from D50 to D65 has the digits that B. Lindbloom publishes") {
    const XYZ d50(0.96422, 1.0, 0.82521);
    const XYZ d65(0.95047, 1.0, 1.08883);
    const Imath::M33d published = Imath::M33d(0.9555766, -0.0230393, 0.0631636,  //
                                              -0.0282895, 1.0099416, 0.0210077,  //
                                              0.0122982, -0.0204830, 1.3299098)
                                      .transposed();  // ours is for row vectors
    CHECK(adaptation(d50, d65).equalWithAbsError(published, 0.5e-7 + 1e-9));
}

TEST_CASE("adaptation from D65 to D50 has the digits of CSS Color 4's sample code") {
    const XYZ d50(0.3457 / 0.3585, 1.0, (1 - 0.3457 - 0.3585) / 0.3585);
    const XYZ d65(0.3127 / 0.3290, 1.0, (1 - 0.3127 - 0.3290) / 0.3290);
    const Imath::M33d published =
        Imath::M33d(1.0479297925449969, 0.022946870601609652,
                    -0.05019226628920524,  //
                    0.02962780877005599, 0.9904344267538799,
                    -0.017073799063418826,  //
                    -0.009243040646204504, 0.015055191490298152, 0.7518742814281371)
            .transposed();
    CHECK(adaptation(d65, d50).equalWithAbsError(published, 1e-14));
}

TEST_CASE("CAT16 is M^-1 D M with the digits that Li et al. 2017 print of M and of M^-1") {
    const Imath::M33d m = Imath::M33d(0.401288, 0.650173, -0.051461,              //
                                      -0.250268, 1.204414, 0.045854,              //
                                      -0.002079, 0.048952, 0.953127);             // (3)
    const Imath::M33d inverse = Imath::M33d(1.86206786, -1.01125463, 0.14918677,  //
                                            0.38752654, 0.62144744, -0.00897398,  //
                                            -0.01584150, -0.03412294, 1.04996444);
    const XYZ a = Observer("A").white();
    const XYZ d65 = Observer("D65").white();
    const Imath::V3d from = a * m.transposed();
    const Imath::V3d to = d65 * m.transposed();
    const Imath::M33d gains(to.x / from.x, 0, 0, 0, to.y / from.y, 0, 0, 0, to.z / from.z);
    // 5e-9 for each printed digit of the inverse, by three gains of up to 3.3 and factors of up to
    // 1.3 of M.
    CHECK(adaptation(a, d65, Adaptation::cat16)
              .equalWithAbsError((inverse * gains * m).transposed(), 3 * 5e-9 * 3.3 * 1.3));
}

TEST_CASE("none leaves every colour as it is; names go both ways") {
    CHECK(adaptation(XYZ(1, 1, 1), XYZ(1, 1, 2), Adaptation::none) == Imath::M33d());
    for (const Adaptation kind : adaptations()) {
        CHECK(adaptationFromName(adaptationName(kind)) == kind);
    }
    CHECK(adaptations().front() == Adaptation::bradford);
    CHECK_FALSE(adaptationFromName("vonkries").has_value());
}

TEST_CASE("a white texel is the light's white, for every space, light and adaptation") {
    for (const ColorSpace& space : colorSpaces()) {
        if (space.isXYZ()) continue;
        for (const std::string& name : illuminantNames()) {
            const Observer light(name);
            for (const Adaptation kind : adaptations()) {
                const XYZ white(Imath::V3d(1, 1, 1) * xyzFromRGB(space, light, kind));
                CHECK(largest(white - light.white()) < kRounding);
            }
        }
    }
}

TEST_CASE("colours of a space under another light are its colours, adapted; with none, its rays") {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> uniform(-0.1, 1.1);
    const Observer light("A");
    for (const char* name : {"srgb", "prophoto", "dcip3", "aces2065-1"}) {
        CAPTURE(name);
        const ColorSpace& space = *findColorSpace(name);
        CHECK(isAdapted(space, light));
        // The space's white is the one of its illuminant, but DCI-P3's, which no illuminant has.
        const XYZ own = std::string(name) == "dcip3" ? xyzOf(Chromaticity{0.314, 0.351})
                                                     : Observer(space.illuminant).white();
        for (const Adaptation kind : kKinds) {
            const Imath::M33d expected =
                xyzFromRGB(space, own) * adaptation(own, light.white(), kind);
            const Imath::M33d matrix = xyzFromRGB(space, light, kind);
            for (int i = 0; i < 100; ++i) {
                const Imath::V3d rgb(uniform(random), uniform(random), uniform(random));
                // The way by chromaticities and Cramer's rule costs some more roundings.
                CHECK(largest(rgb * matrix - rgb * expected) < 64 * kRounding);
            }
        }
        const Imath::M33d rays = xyzFromRGB(space, light, Adaptation::none);
        for (const Imath::V3d& rgb : {Imath::V3d(1, 0, 0), Imath::V3d(0, 1, 0)}) {
            const Chromaticity there = chromaticity(XYZ(rgb * rays));
            const Chromaticity stated = rgb.x == 1 ? space.primaries->red : space.primaries->green;
            CHECK(std::abs(there.x - stated.x) < kRounding);
            CHECK(std::abs(there.y - stated.y) < kRounding);
        }
    }
}

TEST_CASE("DCI-P3 has its own white, and so is adapted under D65; Display P3 is not") {
    const Observer d65("D65");
    CHECK(isAdapted(*findColorSpace("lin_dcip3"), d65));
    CHECK_FALSE(isAdapted(*findColorSpace("lin_displayp3"), d65));
    CHECK_FALSE(isAdapted(*findColorSpace("xyz"), d65));
    const Imath::V3d red(1, 0, 0);
    const Imath::M33d dci = xyzFromRGB(*findColorSpace("lin_dcip3"), d65, Adaptation::bradford);
    const Imath::M33d p3 = xyzFromRGB(*findColorSpace("lin_displayp3"), d65, Adaptation::bradford);
    // The theatre's white is greener than D65: adapted, its red is not Display P3's.
    CHECK(largest(red * dci - red * p3) > 0.01);
}

TEST_CASE("adaptation from a white without blue is refused") {
    CHECK_THROWS_AS(adaptation(XYZ(1, 1, -0.1), XYZ(1, 1, 1)), ArgumentError);
}
