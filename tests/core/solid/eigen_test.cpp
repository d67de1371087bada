#include "solid/eigen.h"

#include <Imath/ImathMatrix.h>
#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace specbake;
using namespace specbake::internal;

namespace {

double dot(const Spectrum& a, const Spectrum& b) {
    double sum = 0;
    for (std::size_t m = 0; m < a.size(); ++m) sum += a[m] * b[m];
    return sum;
}

/// A s of (5), by its definition.
Spectrum apply(const Observer& observer, const Spectrum& s) {
    const XYZ color = observer.color(s);
    Spectrum result;
    for (std::size_t m = 0; m < s.size(); ++m) result[m] = color.dot(observer.weights()[m]);
    return result;
}

/// 81-term sums and a 3x3 eigenproblem of numbers below 2: some hundred roundings.
constexpr double kRounding = 300 * 0x1p-53;

}  // namespace

TEST_CASE("the three modes are orthonormal eigenvectors of A") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const EigenAnalysis eigen(observer);
        const auto& lambda = eigen.values();
        CHECK(lambda[0] >= lambda[1]);
        CHECK(lambda[1] >= lambda[2]);
        CHECK(lambda[2] > 0);
        double trace = 0;
        for (const Imath::V3d& w : observer.weights()) trace += w.length2();
        CHECK(std::abs(lambda[0] + lambda[1] + lambda[2] - trace) < kRounding * trace);
        for (std::size_t k = 0; k < 3; ++k) {
            const Spectrum& mode = eigen.vectors()[k];
            const Spectrum image = apply(observer, mode);
            for (std::size_t m = 0; m < mode.size(); ++m) {
                CHECK(std::abs(image[m] - lambda[k] * mode[m]) < kRounding * lambda[0]);
            }
            for (std::size_t l = 0; l < 3; ++l) {
                // The smaller eigenvalue scales the error of its vector.
                const double expected = k == l ? 1 : 0;
                CHECK(std::abs(dot(mode, eigen.vectors()[l]) - expected) <
                      kRounding * lambda[0] / lambda[2]);
            }
        }
    }
}

TEST_CASE("the first three terms of (12) solve (1), and are the shortest solution") {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const EigenAnalysis eigen(observer);
        const double condition = eigen.values()[0] / eigen.values()[2];
        for (int i = 0; i < 100; ++i) {
            Spectrum s;
            for (double& value : s) value = uniform(random);
            const XYZ color = observer.color(s);
            const Spectrum shortest = eigen.shortestSolution(color);
            CHECK((observer.color(shortest) - color).length() < kRounding * condition);
            // s differs from it by a vector of A's null space, which is orthogonal to it.
            Spectrum difference;
            for (std::size_t m = 0; m < s.size(); ++m) difference[m] = s[m] - shortest[m];
            CHECK(std::abs(dot(difference, shortest)) < kRounding * condition * kBandCount);
        }
    }
}
