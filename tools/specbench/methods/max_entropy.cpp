#include "max_entropy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace specbake::bench {
namespace {

constexpr double kSolved = 1e-13;  // max |W s − t|: some hundred roundings of terms below 1
constexpr double kConverged = 1e-9;
constexpr int kMaxIterations = 200;

double logistic(double x) {
    return 1 / (1 + std::exp(-x));
}

/// ln(1 + e^x) without overflow.
double softplus(double x) {
    return std::max(x, 0.0) + std::log1p(std::exp(-std::abs(x)));
}

double largest(const Imath::V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

/// The dual, its gradient W s − t and its Hessian Σ p σ' v vᵀ.
struct MaxEntropy::State {
    Imath::V3d multipliers;
    double value = 0;
    Imath::V3d gradient;
    Imath::M33d hessian;
};

void MaxEntropy::setUp() {
    bands_.clear();
    for (const Imath::V3d& w : frame().observer.weights()) {
        const double p = w.x + w.y + w.z;
        bands_.push_back({w, w / p, p});
    }
}

MaxEntropy::State MaxEntropy::stateAt(const Imath::V3d& multipliers, const XYZ& target) const {
    State state{multipliers, -multipliers.dot(target), -target, Imath::M33d(0.0)};
    for (const Band& band : bands_) {
        const double x = multipliers.dot(band.chromaticity);
        const double s = logistic(x);
        state.value += band.weight * softplus(x);
        state.gradient += band.w * s;
        const Imath::V3d row = band.w * (s * (1 - s));
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) state.hessian[i][j] += row[i] * band.chromaticity[j];
        }
    }
    return state;
}

Reconstruction MaxEntropy::reconstruct(const XYZ& color) const {
    constexpr double ridge = 1e-15, enough = 1e-4, shortest = 1e-10;
    State at = stateAt(Imath::V3d(0.0), color);
    for (int i = 0; i < kMaxIterations && largest(at.gradient) > kSolved; ++i) {
        Imath::M33d h = at.hessian;
        const double trace = h[0][0] + h[1][1] + h[2][2];
        for (int k = 0; k < 3; ++k) h[k][k] += ridge * trace;
        const Imath::V3d step = -(at.gradient * h.inverse());
        const double slope = at.gradient.dot(step);
        double length = 1;
        State next = stateAt(at.multipliers + step, color);
        // Armijo; near the solution rounding hides the decrease, there a smaller gradient will do.
        while (!(next.value <= at.value + enough * length * slope ||
                 largest(next.gradient) < largest(at.gradient)) &&
               length > shortest) {
            length /= 2;
            next = stateAt(at.multipliers + step * length, color);
        }
        if (length <= shortest) break;
        at = next;
    }
    Reconstruction r{{}, largest(at.gradient) <= kConverged};
    for (std::size_t m = 0; m < r.spectrum.size(); ++m) {
        r.spectrum[m] = logistic(at.multipliers.dot(bands_[m].chromaticity));
    }
    return r;
}

}  // namespace specbake::bench
