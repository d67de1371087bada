#include "support/csv.h"

#include <specbake/core/solid.h>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace specbake;
using specbake::testing::readCsv;

namespace {

/// A row of macadam_limits.csv.
struct Limit {
    double x, y, Y;
    explicit Limit(const std::vector<std::string>& row)
        : x(std::stod(row[1])), y(std::stod(row[2])), Y(std::stod(row[3]) / 100) {}

    XYZ color() const { return {x / y * Y, Y, (1 - x - y) / y * Y}; }

    /// What half a unit of the last printed digit of x and y, the fourth, moves in XYZ.
    double printing() const {
        constexpr double half = 0.5e-4;
        const Imath::V3d byX(1, 0, -1);
        const Imath::V3d byY(-x / y, 0, -1 - (1 - x - y) / y);
        return half * Y / y * (byX.length() + byY.length());
    }
};

/// An ideal spectrum jumps at any wavelength; here a jump within a band is a fraction of the band's
/// weight. The colour then moves along the chord instead of the curve, which stands off by up to an
/// eighth of its second difference: |w_{m+1} − w_{m−1}| / 16 for each band with a jump.
double chordError(const Observer& observer, const Spectrum& s) {
    const auto& w = observer.weights();
    double sum = 0;
    for (std::size_t m = 1; m + 1 < s.size(); ++m) {
        if (s[m - 1] != s[m + 1]) sum += (w[m + 1] - w[m - 1]).length() / 16;
    }
    return sum;
}

}  // namespace

TEST_CASE("published optimal-colour limits lie on the boundary") {
    for (const char* name : {"A", "C", "D65"}) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        int points = 0;
        int astray = 0;
        for (const auto& row : readCsv("tests/data/macadam_limits.csv")) {
            if (row[0] != name) continue;
            const Limit limit(row);
            const XYZ t = limit.color();
            const Solid::Boundary exit = solid.boundary(t);
            const double depth = (1 - exit.gauge) * (exit.color - solid.center()).length();
            const double away = exit.gauge > 1 ? solid.nearest(t).distance : depth;
            ++points;
            if (away > limit.printing() + chordError(observer, exit.spectrum)) ++astray;
        }
        CHECK(points >= 197);
        // The table of C was computed by hand in 1935 and holds slips: (0.32, 0.6357) at Y = 40 is
        // 0.026 inside the solid, the next worst 0.009.
        CHECK(astray == (observer.illuminant() == "C" ? 8 : 0));
    }
}
