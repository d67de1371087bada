#include "solve/second/six.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace specbake::internal {

SixWeights sixWeights(const Observer& first, const Observer& second) {
    SixWeights weights;
    for (std::size_t m = 0; m < weights.size(); ++m) {
        const Imath::V3d &w = first.weights()[m], &v = second.weights()[m];
        weights[m] = {w.x, w.y, w.z, v.x, v.y, v.z};
    }
    return weights;
}

Six colorsOf(const SixWeights& weights, const Spectrum& s) {
    Six colors{};
    for (std::size_t m = 0; m < s.size(); ++m) {
        for (std::size_t e = 0; e < kSix; ++e) colors[e] += weights[m][e] * s[m];
    }
    return colors;
}

Six operator-(const Six& a, const Six& b) {
    Six difference;
    for (std::size_t e = 0; e < kSix; ++e) difference[e] = a[e] - b[e];
    return difference;
}

double largestOf(const Six& v) {
    double largest = 0;
    for (const double value : v) {
        if (std::isnan(value)) return value;
        largest = std::max(largest, std::abs(value));
    }
    return largest;
}

std::optional<Six> solveSix(SixMatrix A, Six b) {
    for (std::size_t i = 0; i < kSix; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < kSix; ++k) {
            if (std::abs(A[k][i]) > std::abs(A[pivot][i])) pivot = k;
        }
        if (!(std::abs(A[pivot][i]) > 0)) return {};
        std::swap(A[i], A[pivot]);
        std::swap(b[i], b[pivot]);
        for (std::size_t k = i + 1; k < kSix; ++k) {
            const double factor = A[k][i] / A[i][i];
            for (std::size_t j = i; j < kSix; ++j) A[k][j] -= factor * A[i][j];
            b[k] -= factor * b[i];
        }
    }
    for (std::size_t i = kSix; i-- > 0;) {
        for (std::size_t k = i + 1; k < kSix; ++k) b[i] -= A[i][k] * b[k];
        b[i] /= A[i][i];
    }
    return b;
}

}  // namespace specbake::internal
