#include <specbake/core/adaptation.h>
#include <specbake/core/error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace specbake {
namespace {

/// Cone responses of a colour, for row vectors.
Imath::M33d conesFromXYZ(Adaptation adaptation) {
    if (adaptation == Adaptation::cat16) {
        return {0.401288, -0.250268, -0.002079, 0.650173, 1.204414,
                0.048952, -0.051461, 0.045854,  0.953127};
    }
    return {0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296};
}

/// Whether the space's illuminant has the white that its standard prints, with four or five digits
/// and for other tables than the 81-term sum.
bool hasWhiteOf(const Primaries& primaries, const Observer& illuminant) {
    constexpr double tolerance = 5e-4;
    const Chromaticity white = chromaticity(illuminant.white());
    return std::abs(white.x - primaries.white.x) < tolerance &&
           std::abs(white.y - primaries.white.y) < tolerance;
}

/// The space's white, as the light's reader has it where there is an illuminant of it: by the usual
/// observer, whoever looks.
XYZ whiteOf(const ColorSpace& space, const Observer& light) {
    const Observer own(space.illuminant, light.quadrature(), light.bands());
    return hasWhiteOf(*space.primaries, own) ? own.white() : xyzOf(space.primaries->white);
}

Chromaticity adapted(const Chromaticity& c, const Imath::M33d& matrix) {
    const Imath::V3d v = Imath::V3d(c.x, c.y, 1 - c.x - c.y) * matrix;
    const double sum = v.x + v.y + v.z;
    if (!(std::abs(sum) > 1e-9)) throw ArgumentError("a primary that has no adapted chromaticity");
    return {v.x / sum, v.y / sum};
}

}  // namespace

std::span<const Adaptation> adaptations() {
    static constexpr std::array all = {Adaptation::bradford, Adaptation::cat16, Adaptation::none};
    return all;
}

std::string_view adaptationName(Adaptation adaptation) {
    switch (adaptation) {
        case Adaptation::bradford:
            return "bradford";
        case Adaptation::cat16:
            return "cat16";
        case Adaptation::none:
            break;
    }
    return "none";
}

std::optional<Adaptation> adaptationFromName(std::string_view name) {
    for (const Adaptation adaptation : adaptations()) {
        if (adaptationName(adaptation) == name) return adaptation;
    }
    return {};
}

Imath::M33d adaptation(const XYZ& from, const XYZ& to, Adaptation adaptation) {
    if (adaptation == Adaptation::none) return {};
    const Imath::M33d cones = conesFromXYZ(adaptation);
    const Imath::V3d before = from * cones;
    const Imath::V3d after = to * cones;
    Imath::M33d gains;
    for (int i = 0; i < 3; ++i) {
        if (!(before[i] > 0)) throw ArgumentError("a white that no eye adapts to");
        gains[i][i] = after[i] / before[i];
    }
    return cones * gains * cones.inverse();
}

bool isAdapted(const ColorSpace& space, const Observer& light) {
    if (space.isXYZ()) return false;
    return light.illuminant() != space.illuminant || !hasWhiteOf(*space.primaries, light);
}

Imath::M33d xyzFromRGB(const ColorSpace& space, const Observer& light, Adaptation kind) {
    if (kind == Adaptation::none || !isAdapted(space, light)) {
        return xyzFromRGB(space, light.white());
    }
    // The primaries' directions alone: their lengths follow from the white, to the last bit as
    // everywhere else.
    const Imath::M33d matrix = adaptation(whiteOf(space, light), light.white(), kind);
    ColorSpace seen = space;
    Primaries& p = *seen.primaries;
    for (Chromaticity* c : {&p.red, &p.green, &p.blue}) *c = adapted(*c, matrix);
    return xyzFromRGB(seen, light.white());
}

}  // namespace specbake
