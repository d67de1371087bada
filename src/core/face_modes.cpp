#include "face_modes.h"

#include <Imath/ImathMatrix.h>
#include <Imath/ImathMatrixAlgo.h>

#include <algorithm>

namespace specbake {
namespace {

Imath::M33d gramMatrix(const Weights& weights, const FreeSet& free) {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    for (const std::size_t m : free) {
        const Imath::V3d& w = weights[m];
        xx += w.x * w.x;
        xy += w.x * w.y;
        xz += w.x * w.z;
        yy += w.y * w.y;
        yz += w.y * w.z;
        zz += w.z * w.z;
    }
    return {xx, xy, xz, xy, yy, yz, xz, yz, zz};
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
    Imath::M33d gram = gramMatrix(weights, free);
    Imath::M33d columns;
    Imath::V3d values;
    Imath::jacobiEigenSolver(gram, values, columns);
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
    FaceModes modes;
    for (unsigned k = 0; k < 3; ++k) {
        const int column = order[k];
        modes.rates[int(k)] = std::max(values[column], 0.0);
        modes.vectors[k] = {columns[0][column], columns[1][column], columns[2][column]};
    }
    return modes;
}

}  // namespace specbake
