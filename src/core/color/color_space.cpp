#include "color/names.h"

#include <specbake/core/color_space.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <array>
#include <cmath>
#include <limits>

namespace specbake {

using namespace internal;

namespace {

/// A point of the ray through a chromaticity, whose y may be 0 or negative (AP0's blue): it
/// suffices, since the ray is scaled afterwards.
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

ColorSpace colorSpaceFromPrimaries(const Primaries& primaries, const Transfer& transfer) {
    for (const ColorSpace& space : colorSpaces()) {
        if (space.transfer == transfer && !space.isXYZ() && agree(*space.primaries, primaries)) {
            return space;
        }
    }
    return {"custom", transfer, primaries, nearestIlluminant(primaries.white)};
}

Primaries primariesFromText(std::string_view text) {
    if (const ColorSpace* space = findColorSpace(text); space != nullptr && !space->isXYZ()) {
        return *space->primaries;
    }
    const auto n = numbersOf(text);
    if (!n || n->size() != 8) {
        throw ArgumentError(
            "primaries are the name of an RGB space or eight numbers, "
            "rx,ry,gx,gy,bx,by,wx,wy, not '" +
            std::string(text) + "'");
    }
    const auto at = [&](std::size_t i) { return Chromaticity{(*n)[i], (*n)[i + 1]}; };
    const Primaries primaries{at(0), at(2), at(4), at(6)};
    // Whether they can be used: these throw.
    static_cast<void>(xyzFromRGB({"custom", {}, primaries, {}}, xyzOf(primaries.white)));
    return primaries;
}

std::string primariesText(const Primaries& p) {
    return decimals(std::array{p.red.x, p.red.y, p.green.x, p.green.y, p.blue.x, p.blue.y,
                               p.white.x, p.white.y});
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
