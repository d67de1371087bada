#include "lit_bands.h"

#include <specbake/core/adaptation.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {

LitBands litBands(const RelightOptions& options) {
    const Observer lit(options.illuminant);
    const XYZ daylight = Observer("D65").white();
    const Imath::M33d shown = xyzFromRGB(*findColorSpace("lin_rec709"), daylight).inverse();
    const Imath::M33d rgbFromXYZ = adaptation(lit.white(), daylight, options.adapt) * shown;
    const Imath::V3d white = lit.white() * rgbFromXYZ;
    const double gain = std::exp2(options.exposure) / std::max({white.x, white.y, white.z});
    LitBands colors;
    for (std::size_t m = 0; m < colors.size(); ++m) {
        colors[m] = Imath::V3f(lit.weights()[m] * rgbFromXYZ * gain);
    }
    return colors;
}

}  // namespace specbake::internal
