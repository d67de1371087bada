#pragma once

#include <Imath/ImathVec.h>

#include <cmath>

namespace specbake {

/// max |v_i|; NaN if a component is.
inline double largestComponent(const Imath::V3d& v) {
    double largest = 0;
    for (const double value : {v.x, v.y, v.z}) {
        if (std::isnan(value)) return value;
        largest = std::fmax(largest, std::abs(value));
    }
    return largest;
}

}  // namespace specbake
