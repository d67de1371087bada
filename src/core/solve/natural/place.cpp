#include "solve/natural/place.h"

#include <cmath>

namespace specbake::internal {

Imath::V3d placeOf(const XYZ& color, const XYZ& white) {
    constexpr double kappa = 0.03;
    const Lab lab = labFromXYZ(color, white);
    const double x = kappa * std::hypot(lab.a, lab.b);
    const double f = x > 0 ? std::log1p(x) / x : 1;
    return {lab.L / 2, lab.a * f, lab.b * f};
}

}  // namespace specbake::internal
