#include <specbake/core/color.h>
#include <specbake/core/error.h>

#include <cmath>

namespace specbake {
namespace {

/// CIE 15, (8.7): the cube root, and the line that meets it below (6/29)^3.
double labResponse(double ratio) {
    constexpr double delta = 6.0 / 29.0;
    return ratio > delta * delta * delta ? std::cbrt(ratio)
                                         : ratio / (3 * delta * delta) + 4.0 / 29.0;
}

}  // namespace

Lab labFromXYZ(const XYZ& color, const XYZ& white) {
    const double fx = labResponse(color.x / white.x);
    const double fy = labResponse(color.y / white.y);
    const double fz = labResponse(color.z / white.z);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Chromaticity chromaticity(const XYZ& color) {
    const double sum = color.x + color.y + color.z;
    if (sum == 0) return {};
    return {color.x / sum, color.y / sum};
}

XYZ xyzOf(const Chromaticity& c) {
    if (!(c.y > 0)) throw ArgumentError("a white without luminance");
    return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

}  // namespace specbake
