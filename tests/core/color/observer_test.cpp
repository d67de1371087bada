#include "support/csv.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace specbake;
using specbake::testing::readCsv;

TEST_CASE("every illuminant's white is the 81-term sum of an independent program") {
    const auto rows = readCsv("tests/data/whitepoints_5nm.csv");
    CHECK(rows.size() == illuminantNames().size());
    for (const auto& row : rows) {
        CAPTURE(row[0]);
        const XYZ white = Observer(row[0]).white();
        // 81 roundings of partial sums below 2.
        const double bound = 81 * 2 * 0x1p-53 * 2;
        CHECK(std::abs(white.x - std::stod(row[2])) < bound);
        CHECK(std::abs(white.y - 1) < bound);
        CHECK(std::abs(white.z - std::stod(row[4])) < bound);
    }
}

TEST_CASE("a reflectance of 1 has the white, of 0 black, exactly") {
    for (const std::string& name : illuminantNames()) {
        const Observer observer(name);
        CHECK(observer.color(constantSpectrum(1)) == observer.white());
        CHECK(observer.color(constantSpectrum(0)) == XYZ(0, 0, 0));
    }
}

TEST_CASE("the ColorChecker has the colours that an independent program gives it") {
    const auto patches = readCsv("data/colorchecker_24.csv");
    REQUIRE(patches.size() == 24);
    int compared = 0;
    for (const auto& row : readCsv("tests/data/oracle_xyz_lab.csv")) {
        std::string illuminant = row[1];
        if (illuminant.starts_with("FL")) illuminant.erase(1, 1);
        const auto patch = std::find_if(patches.begin(), patches.end(),
                                        [&](const auto& p) { return p[0] == row[2]; });
        REQUIRE(patch != patches.end());
        Spectrum s;
        for (std::size_t m = 0; m < s.size(); ++m) s[m] = std::stod((*patch)[m + 1]);
        const Observer observer(illuminant);
        const XYZ color = observer.color(s);
        // The oracle's colour-matching functions are not rounded: half a unit of their ninth
        // decimal in each of 81 terms, times the illuminant's largest share of its luminance.
        const double bound = 1e-7;
        CAPTURE(row[1]);
        CAPTURE(row[2]);
        CHECK(std::abs(color.x - std::stod(row[3])) < bound);
        CHECK(std::abs(color.y - std::stod(row[4])) < bound);
        CHECK(std::abs(color.z - std::stod(row[5])) < bound);
        const Lab lab = labFromXYZ(color, observer.white());
        // dL/dY <= 903.3, da/dX <= 500 * 7.787 (CIE 15), so 3894 times the bound above
        CHECK(std::abs(lab.L - std::stod(row[6])) < 3894 * bound);
        CHECK(std::abs(lab.a - std::stod(row[7])) < 3894 * 2 * bound);
        CHECK(std::abs(lab.b - std::stod(row[8])) < 3894 * 2 * bound);
        ++compared;
    }
    CHECK(compared >= 24 * 6);
}

TEST_CASE("an unknown illuminant is refused") {
    CHECK_THROWS_AS(Observer("D66"), ArgumentError);
}
