#include "solve/face_modes.h"

#include <Imath/ImathMatrix.h>
#include <Imath/ImathMatrixAlgo.h>

#include <cmath>

namespace specbake::internal {
namespace {

/// R of the QR decomposition of the free rows of W^T (n x 3) by modified Gram-Schmidt: G = R^T R.
/// R keeps the small singular values that forming G would round away.
Imath::M33d triangularFactor(const Weights& weights, const FreeSet& free) {
    std::array<Imath::V3d, kBandCount> rows;
    std::size_t count = 0;
    for (const std::size_t m : free) rows[count++] = weights[m];
    Imath::M33d R(0.0);
    for (int j = 0; j < 3; ++j) {
        Imath::V3d products(0.0);
        for (std::size_t i = 0; i < count; ++i) products += rows[i] * rows[i][j];
        const double length = std::sqrt(products[j]);
        if (length == 0) continue;
        R[j][j] = length;
        for (int k = j + 1; k < 3; ++k) {
            R[j][k] = products[k] / length;
            const double share = products[k] / products[j];
            for (std::size_t i = 0; i < count; ++i) rows[i][k] -= share * rows[i][j];
        }
    }
    return R;
}

}  // namespace

Imath::V3d FaceModes::solve(const Imath::V3d& residual) const {
    Imath::V3d sum(0.0);
    for (unsigned k = 0; k < 3; ++k) {
        const double rate = rates[int(k)];
        if (rate > cutoff()) sum += vectors[k] * (vectors[k].dot(residual) / rate);
    }
    return sum;
}

FaceModes faceModes(const Weights& weights, const FreeSet& free) {
    Imath::M33d U;
    Imath::V3d singular;  // descending
    Imath::M33d V;
    Imath::jacobiSVD(triangularFactor(weights, free), U, singular, V);
    FaceModes modes;
    for (unsigned k = 0; k < 3; ++k) {
        const int column = 2 - int(k);
        modes.rates[int(k)] = singular[column] * singular[column];
        modes.vectors[k] = {V[0][column], V[1][column], V[2][column]};
    }
    return modes;
}

}  // namespace specbake::internal
