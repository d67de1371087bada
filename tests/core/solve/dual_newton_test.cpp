#include "solve/dual_newton.h"

#include "solve/descent/descent.h"
#include "support/sample_colors.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace specbake;
using namespace specbake::internal;

namespace {

constexpr double kEps = 0x1p-52;

std::vector<XYZ> sampleColors(const Observer& observer, unsigned seed, int count) {
    testing::SampleColors colors(observer, seed);
    std::vector<XYZ> list;
    for (int i = 0; i < count; ++i) {
        list.push_back(colors.sRGB());
        list.push_back(colors.sRGB(0.05));
        for (const double gauge : {0.9, 0.99, 0.999, 0.99999, 1.0}) {
            list.push_back(colors.atGauge(gauge));
        }
    }
    return list;
}

double largestWeight(const Observer& observer) {
    double largest = 0;
    for (const Imath::V3d& w : observer.weights()) largest = std::max(largest, w.length());
    return largest;
}

}  // namespace

TEST_CASE("the dual Newton satisfies its optimality conditions at every gauge up to 1") {
    for (const char* illuminant : {"E", "D65", "A", "F11"}) {
        const Observer observer(illuminant);
        for (const XYZ& color : sampleColors(observer, 1, 30)) {
            const Spectrum start = constantSpectrum(0.3);
            const NearestReflectance r = nearestReflectance(observer, color, start);
            CHECK(r.residual <= 1e-12);
            CHECK(boundsViolation(r.spectrum) == 0);
            // Each step rounds mu and p once: a few eps of |w| |mu| a step.
            const double rounding = 4 * kEps * (r.iterations + 1) *
                                    (1 + largestWeight(observer) * r.multiplier.length());
            Spectrum kkt;
            for (std::size_t m = 0; m < kkt.size(); ++m) {
                const double p = start[m] + observer.weights()[m].dot(r.multiplier);
                kkt[m] = std::clamp(p, 0.0, 1.0);
            }
            CHECK(maxDifference(kkt, r.spectrum) <= rounding);
        }
    }
}

TEST_CASE("no other reflectance of the same colour is nearer to the start") {
    const Observer observer("D65");
    DescentOptions options;
    options.path = DescentOptions::Path::straight;
    options.bound = DescentOptions::Bound::released;
    const DescentSolver other(observer, options);
    for (const XYZ& color : sampleColors(observer, 2, 30)) {
        const Spectrum start = constantSpectrum(std::min(color.y, 1.0));
        const NearestReflectance nearest = nearestReflectance(observer, color, start);
        const Solution feasible = other.solve(color);
        REQUIRE(feasible.solved());
        // Nearest in a convex set: (s - s0).(f - s) >= 0 for every f of it. For an f whose colour
        // is off by its residual, mu times that is lost; and 81 products are rounded.
        double product = 0;
        for (std::size_t m = 0; m < start.size(); ++m) {
            product +=
                (nearest.spectrum[m] - start[m]) * (feasible.spectrum[m] - nearest.spectrum[m]);
        }
        const double lost = 3 * nearest.multiplier.length() *
                            (nearest.residual + feasible.report.residual + 4 * kEps);
        CHECK(product >= -lost - 81 * kEps);
    }
}

TEST_CASE("every face of the solid is reached, with its only spectrum") {
    const Observer observer("D50");  // the hardest of the ten: steps that are too long fail here
    const auto& w = observer.weights();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    int count = 0;
    for (std::size_t m = 0; m < w.size(); ++m) {
        for (std::size_t k = m + 1; k < w.size(); ++k) {
            for (const double side : {-1.0, 1.0}) {
                const Imath::V3d normal = side * w[m].cross(w[k]);
                if (normal.length() < 1e-9 * w[m].length() * w[k].length()) continue;
                Spectrum face;  // (13)
                for (std::size_t j = 0; j < face.size(); ++j) {
                    face[j] = normal.dot(w[j]) > 0 ? 1 : 0;
                }
                face[m] = uniform(random);
                face[k] = uniform(random);
                const XYZ color = observer.color(face);
                const Spectrum start = constantSpectrum(color.y);
                const NearestReflectance r = nearestReflectance(observer, color, start);
                CHECK(r.residual <= 1e-12);
                // n . (W s - t) is the sum over the components of |n . w_j| times their distance
                // from the face's bound: the residual bounds it, and each term of it, all >= 0.
                double sum = 0;
                for (std::size_t j = 0; j < face.size(); ++j) {
                    if (j == m || j == k) continue;
                    sum += std::abs(normal.dot(w[j])) * std::abs(r.spectrum[j] - face[j]);
                }
                CHECK(sum <= normal.length() * (std::sqrt(3) * r.residual + 4 * kEps));
                ++count;
            }
        }
    }
    CHECK(count > 6000);
}

TEST_CASE("a start that has the colour is its own answer; greys are flat") {
    const Observer observer("D65");
    const DualNewtonSolver solver(observer);
    for (int i = 0; i <= 100; ++i) {
        const double level = i / 100.0;
        const Solution grey = solver.solve(XYZ(observer.white() * level));
        CHECK(grey.solved());
        CHECK(maxDifference(grey.spectrum, constantSpectrum(level)) <= 81 * kEps);
    }
    testing::SampleColors colors(observer, 3);
    for (int i = 0; i < 50; ++i) {
        const XYZ color = colors.sRGB();
        const Solution one = solver.solve(color);
        const Solution again = solver.solveFrom(color, one.spectrum);
        CHECK(again.spectrum == one.spectrum);
        CHECK(again.report.iterations == 0);
    }
}

TEST_CASE("what is not a colour of a surface has failed in the dual Newton too") {
    const DualNewtonSolver solver(Observer("D65"));
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const XYZ& color : {XYZ(-0.1, 0.2, 0.3), XYZ(0.5, 1.5, 0.5), XYZ(1e300, 1, 1),
                             XYZ(nan, 0.1, 0.1), XYZ(0.1, 0.1, inf)}) {
        const Solution solution = solver.solve(color);
        CHECK(solution.report.status == SolveReport::Status::failed);
        CHECK(boundsViolation(solution.spectrum) == 0);
    }
}
