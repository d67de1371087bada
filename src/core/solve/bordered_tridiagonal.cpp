#include "solve/bordered_tridiagonal.h"

#include "solve/newton_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace specbake::internal {
namespace {

constexpr std::size_t kLast = kBandCount - 1;
constexpr std::size_t kDense = 4;  ///< the last x and the three of y

/// A row of right-hand sides: the coupling to the four dense unknowns, then the system's own.
using Row = std::array<double, kDense + 1>;
using DenseSystem = std::array<Row, kDense>;

void subtractMultiple(Row& row, double factor, const Row& other) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= factor * other[i];
}

/// Gauss elimination with partial pivoting; the solution stands in the last column.
bool solveDense(DenseSystem& m) {
    for (std::size_t pivot = 0; pivot < kDense; ++pivot) {
        std::size_t best = pivot;
        for (std::size_t i = pivot + 1; i < kDense; ++i) {
            if (std::abs(m[i][pivot]) > std::abs(m[best][pivot])) best = i;
        }
        std::swap(m[pivot], m[best]);
        const double value = m[pivot][pivot];
        if (!(std::abs(value) > std::numeric_limits<double>::min())) return false;
        for (double& entry : m[pivot]) entry /= value;
        for (std::size_t i = 0; i < kDense; ++i) {
            if (i != pivot) subtractMultiple(m[i], m[i][pivot], m[pivot]);
        }
    }
    return true;
}

double awayFromZero(double pivot) {
    return std::abs(pivot) < kLeastPivot ? std::copysign(kLeastPivot, pivot) : pivot;
}

}  // namespace

bool solveInPlace(const BorderedTridiagonal& system, BorderedVector& right) {
    // Row i of the leading block: d_i x_i - x_{i-1} - x_{i+1} + couplings · dense = right_i.
    std::array<Row, kBandCount> rows;
    std::array<double, kBandCount> inverse;
    for (std::size_t i = 0; i < kLast; ++i) {
        const Imath::V3d& j = system.border[i];
        rows[i] = {i + 1 == kLast ? -1.0 : 0.0, j.x, j.y, j.z, right.x[i]};
        double pivot = system.diagonal[i];
        if (i > 0) {
            pivot -= inverse[i - 1];
            subtractMultiple(rows[i], -inverse[i - 1], rows[i - 1]);
        }
        inverse[i] = 1 / awayFromZero(pivot);
    }
    // Back substitution: x_i = rows[i][4] - rows[i][0..3] · dense.
    for (std::size_t i = kLast; i-- > 0;) {
        if (i + 1 < kLast) subtractMultiple(rows[i], -1, rows[i + 1]);
        for (double& entry : rows[i]) entry *= inverse[i];
    }
    // The four dense equations, with the leading unknowns replaced.
    const Imath::V3d& last = system.border[kLast];
    DenseSystem dense = {{{system.diagonal[kLast], last.x, last.y, last.z, right.x[kLast]},
                          {last.x, 0, 0, 0, right.y.x},
                          {last.y, 0, 0, 0, right.y.y},
                          {last.z, 0, 0, 0, right.y.z}}};
    subtractMultiple(dense[0], -1, rows[kLast - 1]);
    for (std::size_t i = 0; i < kLast; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            subtractMultiple(dense[k + 1], system.border[i][int(k)], rows[i]);
        }
    }
    if (!solveDense(dense)) return false;
    for (std::size_t i = 0; i < kLast; ++i) {
        right.x[i] = rows[i][4];
        for (std::size_t k = 0; k < kDense; ++k) right.x[i] -= rows[i][k] * dense[k][4];
    }
    right.x[kLast] = dense[0][4];
    right.y = {dense[1][4], dense[2][4], dense[3][4]};
    return true;
}

}  // namespace specbake::internal
