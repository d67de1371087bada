#pragma once

#include <specbake/core/api.h>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

struct Primaries {
    Chromaticity red, green, blue, white;
    bool operator==(const Primaries&) const = default;
};

/// How a texture's stored numbers become linear ones.
enum class Transfer { linear, sRGB };

/// Of an encoded component.
SPECBAKE_API double linearFrom(double encoded, Transfer transfer);

/// sRGB's decoding curve (IEC 61966-2-1), odd about 0, extended above 1.
SPECBAKE_API double linearFromSRGB(double encoded);
/// Its inverse.
SPECBAKE_API double sRGBFromLinear(double linear);

/// A colour space that a texture may be in: an RGB space by its primaries, or XYZ itself.
struct ColorSpace {
    std::string name;
    Transfer transfer = Transfer::linear;
    std::optional<Primaries> primaries;  ///< none: the three channels are X, Y, Z
    std::string illuminant;              ///< the space's own white, by name (observer.h)

    bool isXYZ() const { return !primaries; }
};

/// Every space that `--space` offers, in the order in which help lists them.
SPECBAKE_API const std::vector<ColorSpace>& colorSpaces();

/// The space of that name, or nullptr.
SPECBAKE_API const ColorSpace* findColorSpace(std::string_view name);

/// The linear space with these primaries: a known one where they agree to 4 decimals, else one
/// named "custom" whose illuminant is the offered one nearest in chromaticity.
SPECBAKE_API ColorSpace colorSpaceFromPrimaries(const Primaries& primaries);

/// XYZ from linear RGB: row i is the tristimulus of primary i, so that XYZ(rgb * matrix).
/// (1, 1, 1) goes to `white`. Identity for XYZ.
/// Throws ArgumentError if the primaries lie on one line.
SPECBAKE_API Imath::M33d xyzFromRGB(const ColorSpace& space, const XYZ& white);

}  // namespace specbake
