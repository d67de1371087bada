#include "lit_bands.h"

#include "reading.h"

#include <specbake/core/adaptation.h>
#include <specbake/core/color.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {

LitBands litBands(const std::string& path, const SpectralReader& reader,
                  const RelightOptions& options) {
    const Quadrature quadrature =
        options.quadrature ? *options.quadrature : statedQuadrature(path, reader);
    const auto lit = readerWeights(path, reader, options.illuminant, quadrature,
                                   options.observer.value_or(statedObserver(path, reader)));
    const XYZ litWhite = whiteOf(lit);
    // The screen's colours are those that the usual observer sees.
    const XYZ daylight = whiteOf(readerWeights(path, reader, "D65", quadrature));
    const Imath::M33d shown = xyzFromRGB(*findColorSpace("lin_rec709"), daylight).inverse();
    const Imath::M33d rgbFromXYZ = adaptation(litWhite, daylight, options.adapt) * shown;
    const Imath::V3d white = litWhite * rgbFromXYZ;
    const double gain = std::exp2(options.exposure) / std::max({white.x, white.y, white.z});
    LitBands colors;
    for (const Imath::V3d& w : lit) colors.push_back(Imath::V3f(w * rgbFromXYZ * gain));
    return colors;
}

}  // namespace specbake::internal
