#include <specbake/core/color.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake {
namespace {

/// CIE 15, (8.7): the cube root, and the line that meets it below (6/29)^3.
double labResponse(double ratio) {
    constexpr double delta = 6.0 / 29.0;
    return ratio > delta * delta * delta ? std::cbrt(ratio)
                                         : ratio / (3 * delta * delta) + 4.0 / 29.0;
}

/// The tristimulus of unit luminance at a chromaticity whose y may be 0 or negative (AP0's blue):
/// a point of the ray through it suffices, since the ray is scaled afterwards.
Imath::V3d rayOf(const Chromaticity& c) {
    return {c.x, c.y, 1 - c.x - c.y};
}

double distance2(const Chromaticity& a, const Chromaticity& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

std::string nearestIlluminant(const Chromaticity& white) {
    std::string nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (const std::string& name : illuminantNames()) {
        const double d = distance2(white, chromaticity(Observer(name).white()));
        if (d < smallest) {
            smallest = d;
            nearest = name;
        }
    }
    return nearest;
}

bool agree(const Primaries& a, const Primaries& b) {
    constexpr double tolerance2 = 1e-4 * 1e-4;  // standards print four or five decimals
    return distance2(a.red, b.red) < tolerance2 && distance2(a.green, b.green) < tolerance2 &&
           distance2(a.blue, b.blue) < tolerance2 && distance2(a.white, b.white) < tolerance2;
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

double linearFrom(double encoded, Transfer transfer) {
    return transfer == Transfer::sRGB ? linearFromSRGB(encoded) : encoded;
}

double linearFromSRGB(double encoded) {
    const double v = std::abs(encoded);
    const double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    return std::copysign(linear, encoded);
}

double sRGBFromLinear(double linear) {
    const double v = std::abs(linear);
    const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return std::copysign(encoded, linear);
}

const std::vector<ColorSpace>& colorSpaces() {
    constexpr Chromaticity d65{0.3127, 0.3290};
    constexpr Chromaticity d50{0.3457, 0.3585};
    constexpr Chromaticity aces{0.32168, 0.33767};
    constexpr Chromaticity theatre{0.314, 0.351};
    constexpr Primaries rec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65};
    constexpr Primaries p3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65};
    constexpr Primaries dciP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, theatre};
    constexpr Primaries adobe{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, d65};
    constexpr Primaries rec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65};
    constexpr Primaries ap1{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, aces};
    constexpr Primaries ap0{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, aces};
    constexpr Primaries romm{{0.7347, 0.2653}, {0.1596, 0.8404}, {0.0366, 0.0001}, d50};
    static const std::vector<ColorSpace> spaces = {
        {"srgb", Transfer::sRGB, rec709, "D65"},
        {"lin_rec709", Transfer::linear, rec709, "D65"},
        {"lin_displayp3", Transfer::linear, p3, "D65"},
        {"lin_dcip3", Transfer::linear, dciP3, "D65"},
        {"lin_adobergb", Transfer::linear, adobe, "D65"},
        {"lin_rec2020", Transfer::linear, rec2020, "D65"},
        {"acescg", Transfer::linear, ap1, "D60"},
        {"aces2065-1", Transfer::linear, ap0, "D60"},
        {"prophoto", Transfer::linear, romm, "D50"},
        {"xyz", Transfer::linear, std::nullopt, "E"},
    };
    return spaces;
}

const ColorSpace* findColorSpace(std::string_view name) {
    for (const ColorSpace& space : colorSpaces()) {
        if (space.name == name) return &space;
    }
    return nullptr;
}

ColorSpace colorSpaceFromPrimaries(const Primaries& primaries) {
    for (const ColorSpace& space : colorSpaces()) {
        if (space.transfer == Transfer::linear && !space.isXYZ() &&
            agree(*space.primaries, primaries)) {
            return space;
        }
    }
    return {"custom", Transfer::linear, primaries, nearestIlluminant(primaries.white)};
}

Imath::M33d xyzFromRGB(const ColorSpace& space, const XYZ& white) {
    if (space.isXYZ()) return {};
    const Imath::V3d r = rayOf(space.primaries->red);
    const Imath::V3d g = rayOf(space.primaries->green);
    const Imath::V3d b = rayOf(space.primaries->blue);
    const double volume = r.dot(g.cross(b));
    if (!(std::abs(volume) > 1e-9)) {  // printed chromaticities that span a plane exceed it by far
        throw ArgumentError("the primaries of '" + space.name + "' lie on one line");
    }
    // Cramer's rule for Sr r + Sg g + Sb b = white.
    const Imath::V3d red = r * (white.dot(g.cross(b)) / volume);
    const Imath::V3d green = g * (r.dot(white.cross(b)) / volume);
    const Imath::V3d blue = b * (r.dot(g.cross(white)) / volume);
    return {red.x, red.y, red.z, green.x, green.y, green.z, blue.x, blue.y, blue.z};
}

}  // namespace specbake
