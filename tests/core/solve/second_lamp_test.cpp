#include "solve/natural/natural.h"
#include "solve/shell.h"
#include "support/solid_samples.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/second_lamp.h>
#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

struct Bench {
    Bench() : first("D65"), second("A"), smooth(first), lamp(first, second) {}

    double miss(const Observer& light, const Spectrum& a, const Spectrum& b) const {
        return largestComponent(light.color(a) - light.color(b));
    }

    Observer first, second;
    ShellSolver smooth;
    SecondLamp lamp;
};

/// A reflectance of a few random steps and slopes.
Spectrum randomReflectance(Random& random) {
    Spectrum s;
    const double low = random(0, 0.5), high = random(0.5, 1), edge = random(0, 80);
    const double width = random(1, 30), bump = random(-0.2, 0.2), at = random(0, 80);
    for (std::size_t m = 0; m < s.size(); ++m) {
        const double step = 0.5 * (1 + std::tanh((double(m) - edge) / width));
        const double hill = bump * std::exp(-std::pow((double(m) - at) / 8, 2));
        s[m] = std::clamp(low + (high - low) * step + hill, 0.01, 0.99);
    }
    return s;
}

}  // namespace

TEST_CASE("where a reflectance has both colours, the result has both: 3000 of them") {
    const Bench bench;
    Random random(91);
    int reached = 0;
    constexpr int count = 3000;
    for (int i = 0; i < count; ++i) {
        const Spectrum s = randomReflectance(random);
        const Spectrum base = bench.smooth.solve(bench.first.color(s)).spectrum;
        const auto answer = bench.lamp.move(base, bench.second.color(s));
        REQUIRE(withinBounds(answer.spectrum));
        // The steps' tolerance, the base's, and roundings of sums.
        const double tolerance = 4e-12 + 4 * sumRounding(bench.smooth.solid());
        REQUIRE(bench.miss(bench.first, answer.spectrum, s) <= tolerance);
        REQUIRE(answer.met);
        const double second = bench.miss(bench.second, answer.spectrum, s);
        REQUIRE(second <= SecondLamp::kNearTolerance);
        reached += second <= tolerance;
    }
    CHECK(reached >= count * 99 / 100);
}

TEST_CASE("with the colour under A, measured surfaces under F11 and F2 come out twice as near") {
    const Bench bench;
    const auto smooth = std::make_shared<const ShellSolver>(bench.first);
    for (const char* light : {"F11", "F2"}) {
        const Observer lamp(light);
        const auto lab = [&](const Spectrum& s) { return labFromXYZ(lamp.color(s), lamp.white()); };
        const std::array<std::string_view, 1> left{"DuPont"};
        const NaturalSolver natural(bench.first, smooth, builtInSetsWithout(left));
        double before = 0, after = 0;
        for (const MeasuredSet& set : builtInSets()) {
            if (set.name != left[0]) continue;
            for (const MeasuredSample& sample : set.samples) {
                const Spectrum& s = sample.reflectance;
                const Spectrum base = natural.solve(bench.first.color(s)).spectrum;
                const auto answer = bench.lamp.move(base, bench.second.color(s));
                CHECK(answer.met);
                before += ciede2000(lab(base), lab(s));
                after += ciede2000(lab(answer.spectrum), lab(s));
            }
        }
        CHECK(after <= before / 2);
    }
}

/// c·x over the reflectances x of a colour is at least this, by linear programming's weak duality:
///
///     min { c·x : W x = t, 0 <= x <= 1 } >= ν·t + Σ min(0, (c − ν·W)_m)   for any ν.
///
/// ν comes from Newton's steps on the concave right side, its corners rounded off less and less.
double leastProduct(const Observer& light, const XYZ& color, const Spectrum& c) {
    constexpr double sharpest = 1e-13;
    const auto& w = light.weights();
    const auto slack = [&](const Imath::V3d& nu, std::size_t m) { return c[m] - nu.dot(w[m]); };
    const auto bound = [&](const Imath::V3d& nu) {
        double sum = nu.dot(color);
        for (std::size_t m = 0; m < c.size(); ++m) sum += std::min(0.0, slack(nu, m));
        return sum;
    };
    const auto rounded = [&](const Imath::V3d& nu, double round) {
        double sum = nu.dot(color);
        for (std::size_t m = 0; m < c.size(); ++m) {
            const double x = -slack(nu, m) / round;  // ln(1 + eˣ)
            sum -= round * (std::max(0.0, x) + std::log1p(std::exp(-std::abs(x))));
        }
        return sum;
    };
    Imath::V3d nu(0.0);
    for (double round = 1; round >= sharpest; round /= 2) {
        for (int step = 0; step < 12; ++step) {
            Imath::V3d gradient = color;
            Imath::M33d bend(1e-9, 0, 0, 0, 1e-9, 0, 0, 0, 1e-9);
            for (std::size_t m = 0; m < c.size(); ++m) {
                const double x = 0.5 * (1 + std::tanh(-slack(nu, m) / (2 * round)));
                gradient -= w[m] * x;
                for (int a = 0; a < 3; ++a) {
                    for (int b = 0; b < 3; ++b) {
                        bend[a][b] += x * (1 - x) / round * w[m][a] * w[m][b];
                    }
                }
            }
            Imath::V3d change = gradient * bend.inverse();
            for (int half = 0; half < 60 && rounded(nu + change, round) < rounded(nu, round);
                 ++half) {
                change *= 0.5;
            }
            nu += change;
        }
    }
    return bound(nu);
}

/// How much nearer, in ½ of the squared distance, any reflectance with the first colour could be:
/// at most this, as ½|r + W₂(x − s)|² >= ½|r|² + r·W₂(x − s).
double roomLeft(const Bench& bench, const Spectrum& s, const XYZ& first, const XYZ& asked) {
    const Imath::V3d r = bench.second.color(s) - asked;
    Spectrum c;
    double now = 0;
    for (std::size_t m = 0; m < s.size(); ++m) {
        c[m] = r.dot(bench.second.weights()[m]);
        now += c[m] * s[m];
    }
    return now - leastProduct(bench.first, first, c);
}

TEST_CASE("where no reflectance has both, the first is kept and the second is the nearest") {
    const Bench bench;
    Random random(92);
    for (int i = 0; i < 100; ++i) {
        const Spectrum s = randomReflectance(random);
        const Spectrum base = bench.smooth.solve(bench.first.color(s)).spectrum;
        const XYZ from = bench.second.color(base);
        const double far = i % 2 == 0 ? 2 : 0.2;  // far outside, and where it is tight
        const XYZ asked(from + random.direction() * far);
        const auto answer = bench.lamp.move(base, asked);
        CHECK_FALSE(answer.met);
        CHECK(withinBounds(answer.spectrum));
        CHECK(bench.miss(bench.first, answer.spectrum, base) <= 1e-11);
        // The bound's roundness, 81 ln 2 of it, times 10, and the method's product of slacks.
        CHECK(roomLeft(bench, answer.spectrum, bench.first.color(base), asked) <= 1e-10);
    }
}

TEST_CASE("white, black, and what has the colour already, stay as they are") {
    const Bench bench;
    Random random(93);
    for (const Spectrum& s :
         {constantSpectrum(1), constantSpectrum(0), randomReflectance(random)}) {
        const auto answer = bench.lamp.move(s, bench.second.color(s));
        CHECK(answer.spectrum == s);
        CHECK(answer.met);
    }
    const auto dark = bench.lamp.move(constantSpectrum(0), XYZ(0.1, 0.1, 0.1));
    CHECK_FALSE(dark.met);
    CHECK(maxDifference(dark.spectrum, constantSpectrum(0)) <= 1e-11);
}
