#include "solve/first_step.h"

#include "solve/bordered_tridiagonal.h"
#include "solve/newton_limits.h"

#include <algorithm>
#include <cmath>

namespace specbake::internal {

FirstStep::FirstStep(const Observer& observer) : white_(observer.white()) {
    BorderedTridiagonal system;
    for (std::size_t m = 0; m < kBandCount; ++m) {
        system.diagonal[m] = m == 0 || m + 1 == kBandCount ? 1 : 2;
        system.border[m] = observer.weights()[m];
    }
    for (int k = 0; k < 3; ++k) {
        BorderedVector step{};
        step.x.fill(0);
        step.y = Imath::V3d(0.0);
        step.y[k] = 1;
        static_cast<void>(solveInPlace(system, step));  // W has the rank 3
        for (std::size_t m = 0; m < kBandCount; ++m) z_[m][k] = step.x[m];
        for (int i = 0; i < 3; ++i) multipliers_[k][i] = step.y[i];
    }
}

FirstStep::Point FirstStep::from(const XYZ& color) const {
    const double s = std::clamp(color.y, kLeastLuminance, 1 - kLeastLuminance);
    const double slope = 2 * s * (1 - s);
    const Imath::V3d right = (white_ * s - color) / slope;
    Point point;
    double longest = 0;
    for (std::size_t m = 0; m < kBandCount; ++m) {
        point.z[m] = z_[m].dot(right);
        longest = std::max(longest, std::abs(point.z[m]));
    }
    const double damping = std::min(1.0, kLongestStep / longest);
    const double start = 0.5 * std::log(s / (1 - s));
    for (double& z : point.z) z = start - damping * z;
    point.multipliers = right * multipliers_ * (-damping / slope);
    return point;
}

}  // namespace specbake::internal
