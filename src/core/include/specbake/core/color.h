#pragma once

#include <specbake/core/api.h>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

namespace specbake {

/// CIE 1931 tristimulus values, scaled so that the perfect reflector has Y = 1. XYZ and RGB are
/// different types: one becomes the other only by a matrix. Their differences are plain vectors.
struct XYZ : Imath::V3d {
    XYZ() : Imath::V3d(0.0) {}
    XYZ(double X, double Y, double Z) : Imath::V3d(X, Y, Z) {}
    explicit XYZ(const Imath::V3d& v) : Imath::V3d(v) {}
};

/// Linear RGB of some colour space; (1, 1, 1) is its white.
struct RGB : Imath::V3d {
    RGB() : Imath::V3d(0.0) {}
    RGB(double r, double g, double b) : Imath::V3d(r, g, b) {}
    explicit RGB(const Imath::V3d& v) : Imath::V3d(v) {}
};

/// CIE 1976 L*a*b*, L in [0, 100].
struct Lab {
    double L = 0, a = 0, b = 0;
};

/// Lab of a colour beside its white (CIE 15). Any finite colour has one.
SPECBAKE_API Lab labFromXYZ(const XYZ& color, const XYZ& white);

struct Chromaticity {
    double x = 0, y = 0;
    bool operator==(const Chromaticity&) const = default;
};

/// (3) of the paper; (0, 0) for black.
SPECBAKE_API Chromaticity chromaticity(const XYZ& color);

/// The colour of that chromaticity with Y = 1. Throws ArgumentError if y is not above 0.
SPECBAKE_API XYZ xyzOf(const Chromaticity& c);

struct Primaries {
    Chromaticity red, green, blue, white;
    bool operator==(const Primaries&) const = default;
};

}  // namespace specbake
