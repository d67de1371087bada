#include <specbake/core/adaptation.h>
#include <specbake/core/error.h>

namespace specbake {
namespace {

/// Bradford's cone responses of a colour, for row vectors.
Imath::M33d conesFromXYZ() {
    return {0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296};
}

}  // namespace

Imath::M33d adaptation(const XYZ& from, const XYZ& to) {
    const Imath::M33d cones = conesFromXYZ();
    const Imath::V3d before = from * cones;
    const Imath::V3d after = to * cones;
    Imath::M33d gains;
    for (int i = 0; i < 3; ++i) {
        if (!(before[i] > 0)) throw ArgumentError("a white that no eye adapts to");
        gains[i][i] = after[i] / before[i];
    }
    return cones * gains * cones.inverse();
}

}  // namespace specbake
