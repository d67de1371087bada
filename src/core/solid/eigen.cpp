#include "solid/eigen.h"

#include <Imath/ImathMatrix.h>
#include <Imath/ImathMatrixAlgo.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

Imath::M33d gramMatrix(const Observer& observer) {
    Imath::M33d gram(0.0);
    for (const Imath::V3d& w : observer.weights()) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) gram[i][j] += w[i] * w[j];
        }
    }
    return gram;
}

/// (10)
Spectrum combine(const Observer& observer, const Imath::V3d& coefficients) {
    Spectrum s;
    for (std::size_t m = 0; m < s.size(); ++m) s[m] = coefficients.dot(observer.weights()[m]);
    return s;
}

double largestComponent(const Spectrum& s) {
    return *std::max_element(s.begin(), s.end(),
                             [](double a, double b) { return std::abs(a) < std::abs(b); });
}

}  // namespace

EigenAnalysis::EigenAnalysis(const Observer& observer) {
    Imath::M33d gram = gramMatrix(observer);
    Imath::V3d lambda;
    Imath::M33d columns;
    Imath::jacobiEigenSolver(gram, lambda, columns);
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return lambda[a] > lambda[b]; });
    for (std::size_t k = 0; k < 3; ++k) {
        const int column = order[k];
        values_[k] = lambda[column];
        const Imath::V3d alpha(columns[0][column], columns[1][column], columns[2][column]);
        // ‖Σ α w‖² = α·Gram α = Λ for a unit α.
        const double length = std::sqrt(values_[k]);
        const double sign = std::copysign(1.0, largestComponent(combine(observer, alpha)));
        coefficients_[k] = alpha * (sign / length);
        vectors_[k] = combine(observer, coefficients_[k]);
    }
}

Spectrum EigenAnalysis::shortestSolution(const XYZ& color) const {
    Spectrum s{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double amount = color.dot(coefficients_[k]);
        for (std::size_t m = 0; m < s.size(); ++m) s[m] += amount * vectors_[k][m];
    }
    return s;
}

}  // namespace specbake::internal
