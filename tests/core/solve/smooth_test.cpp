#include "solve/smooth.h"

#include <specbake/core/color_space.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace specbake;
using namespace specbake::internal;

namespace {

double worstDifference(const XYZ& a, const XYZ& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace

TEST_CASE("black, white and greys are exact") {
    for (const std::string& name : illuminantNames()) {
        const Observer observer(name);
        const SmoothSolver solver(observer);
        CHECK(solver.solve(XYZ(0, 0, 0)).spectrum == constantSpectrum(0));
        CHECK(solver.solve(observer.white()).spectrum == constantSpectrum(1));
        for (const double grey : {1e-6, 0.001, 0.18, 0.5, 0.999}) {
            const Solution solution = solver.solve(XYZ(observer.white() * grey));
            REQUIRE(solution.solved());
            // Y of white is 1 to 81 roundings.
            CHECK(maxDifference(solution.spectrum, constantSpectrum(grey)) <= 81 * 0x1p-52 * grey);
        }
    }
}

TEST_CASE("white of every colour space is the spectrum 1, exactly") {
    for (const ColorSpace& space : colorSpaces()) {
        if (space.isXYZ()) continue;
        const Observer observer(space.illuminant);
        const XYZ white(RGB(1, 1, 1) * xyzFromRGB(space, observer.white()));
        CAPTURE(space.name);
        CHECK(SmoothSolver(observer).solve(white).spectrum == constantSpectrum(1));
    }
}

TEST_CASE("colours of the sRGB cube: solved, exact, within the bounds") {
    const Observer observer("D65");
    const SmoothSolver solver(observer);
    const auto matrix = xyzFromRGB(*findColorSpace("lin_rec709"), observer.white());
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const double scale : {1.0, 0.05, 1e-4}) {
        for (int trial = 0; trial < 2000; ++trial) {
            const RGB rgb(scale * uniform(random), scale * uniform(random),
                          scale * uniform(random));
            const XYZ color(rgb * matrix);
            const Solution solution = solver.solve(color);
            REQUIRE(solution.solved());
            CHECK(boundsViolation(solution.spectrum) == 0);
            // The solver stops at 1e-12 of the colour; 81 roundings in the sum here.
            CHECK(worstDifference(observer.color(solution.spectrum), color) <=
                  (1e-12 + 81 * 0x1p-53) * 1.1 * scale);
        }
    }
}

TEST_CASE("the slope is stationary: its gradient is a combination of the three constraints'") {
    // Burns 2020: with z = atanh(2s - 1) there are three multipliers λ such that for every band
    // (2 z_m - z_{m-1} - z_{m+1}) + 2 s_m (1 - s_m) w_m·λ = 0. Least squares finds them.
    const Observer observer("D65");
    const SmoothSolver solver(observer);
    const auto matrix = xyzFromRGB(*findColorSpace("lin_rec709"), observer.white());
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> uniform(0.02, 0.98);
    for (int trial = 0; trial < 500; ++trial) {
        const RGB rgb(uniform(random), uniform(random), uniform(random));
        const Spectrum s = solver.solve(XYZ(rgb * matrix)).spectrum;
        Spectrum z;
        for (std::size_t m = 0; m < s.size(); ++m) z[m] = std::atanh(2 * s[m] - 1);
        Spectrum slope;
        for (std::size_t m = 0; m < s.size(); ++m) {
            slope[m] = (m > 0 ? z[m] - z[m - 1] : 0) + (m + 1 < s.size() ? z[m] - z[m + 1] : 0);
        }
        Imath::M33d gram(0.0);
        Imath::V3d right(0.0);
        const auto column = [&](std::size_t m) {
            return observer.weights()[m] * (2 * s[m] * (1 - s[m]));
        };
        for (std::size_t m = 0; m < s.size(); ++m) {
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) gram[i][j] += column(m)[i] * column(m)[j];
            }
            right -= column(m) * slope[m];
        }
        const Imath::V3d multipliers = right * gram.inverse();
        for (std::size_t m = 0; m < s.size(); ++m) {
            // The solver stops at 1e-9; z is read back from s to 1e-16 / (1 - s).
            CHECK(std::abs(slope[m] + column(m).dot(multipliers)) <= 1e-8);
        }
    }
}
