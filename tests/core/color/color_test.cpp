#include "support/csv.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/color_space.h>
#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace specbake;
using specbake::testing::readCsv;

TEST_CASE("CIEDE2000 gives the published 34 differences, both ways round") {
    for (const auto& row : readCsv("tests/data/ciede2000_sharma_34.csv")) {
        if (row[0] == "14")
            continue;  // on the tie of a 180-degree hue difference: rounding decides
        const Lab a{std::stod(row[1]), std::stod(row[2]), std::stod(row[3])};
        const Lab b{std::stod(row[4]), std::stod(row[5]), std::stod(row[6])};
        CAPTURE(row[0]);
        const double printed = 0.5e-4;  // four decimals
        CHECK(std::abs(ciede2000(a, b) - std::stod(row[7])) <= printed * (1 + 1e-9));
        CHECK(std::abs(ciede2000(b, a) - std::stod(row[7])) <= printed * (1 + 1e-9));
    }
}

TEST_CASE("matrices agree with the published ones where the white is the published one") {
    const std::pair<const char*, const char*> names[] = {{"sRGB / Rec709", "lin_rec709"},
                                                         {"Rec2020", "lin_rec2020"},
                                                         {"ACEScg AP1", "acescg"},
                                                         {"ACES2065-1 AP0", "aces2065-1"},
                                                         {"DCI-P3", "lin_dcip3"},
                                                         {"Display P3 / P3-D65", "lin_displayp3"},
                                                         {"Adobe RGB (1998)", "lin_adobergb"},
                                                         {"ProPhoto / ROMM", "prophoto"}};
    const auto rows = readCsv("tests/data/rgb_matrices.csv");
    for (const auto& [published, name] : names) {
        CAPTURE(name);
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const auto& r) { return r[0] == published; });
        REQUIRE(row != rows.end());
        const auto number = [&](std::size_t i) { return std::stod((*row)[i]); };
        const Imath::M33d m =
            xyzFromRGB(*findColorSpace(name), XYZ(number(1), number(2), number(3)));
        for (int primary = 0; primary < 3; ++primary) {
            for (int component = 0; component < 3; ++component) {
                // a dozen roundings of numbers of order 1 through a well-conditioned 3x3 solve
                CHECK(std::abs(m[primary][component] -
                               number(std::size_t(4 + 3 * component + primary))) < 1e-14);
            }
        }
    }
}

TEST_CASE("primaries read back from a file name their space") {
    for (const ColorSpace& space : colorSpaces()) {
        if (space.isXYZ() || space.transfer != Transfer::linear) continue;
        CHECK(colorSpaceFromPrimaries(*space.primaries).name == space.name);
    }
    const Primaries own{{0.6, 0.35}, {0.3, 0.6}, {0.15, 0.07}, {0.3457, 0.3585}};
    CHECK(colorSpaceFromPrimaries(own).name == "custom");
    CHECK(colorSpaceFromPrimaries(own).illuminant == "D50");
}

TEST_CASE("primaries on one line are refused") {
    const ColorSpace flat{"flat", Transfer::linear,
                          Primaries{{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, {0.3, 0.3}}, "E"};
    CHECK_THROWS_AS(xyzFromRGB(flat, XYZ(1, 1, 1)), ArgumentError);
}

TEST_CASE("sRGB's curve: its published corner, its inverse, odd and monotonic") {
    CHECK(linearFromSRGB(0) == 0);
    CHECK(linearFromSRGB(1) == 1);
    // IEC 61966-2-1 prints the corner to 5 digits: the two pieces meet within that.
    CHECK(std::abs(linearFromSRGB(0.04045) - 0.0031308) < 1e-7);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-2, 2);
    double previous = -10;
    for (int i = 0; i < 1000; ++i) {
        const double v = -2 + i * 0.004;
        CHECK(linearFromSRGB(v) > previous);
        previous = linearFromSRGB(v);
        const double u = uniform(random);
        CHECK(linearFromSRGB(-u) == -linearFromSRGB(u));
        // The standard's two corners, 0.04045 and 0.0031308, differ by 3e-8 in linear, times 12.92.
        CHECK(std::abs(sRGBFromLinear(linearFromSRGB(u)) - u) < 12.92 * 3e-8);
    }
}

TEST_CASE("Lab: white, black, and the line below (6/29)^3") {
    const XYZ white(0.95, 1, 1.09);
    const Lab w = labFromXYZ(white, white);
    CHECK(w.L == doctest::Approx(100).epsilon(1e-15));
    CHECK(w.a == 0);
    CHECK(w.b == 0);
    CHECK(std::abs(labFromXYZ(XYZ(0, 0, 0), white).L) < 1e-13);
    // CIE 15: L = 903.3 Y on the line, exactly (29/3)^3.
    const double Y = 0.001;
    CHECK(labFromXYZ(XYZ(0.95 * Y, Y, 1.09 * Y), white).L ==
          doctest::Approx(std::pow(29.0 / 3.0, 3) * Y).epsilon(1e-12));
}
