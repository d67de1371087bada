#include "upsample/node_values.h"

#include <specbake/core/color_space.h>

namespace specbake::internal {

NodeEncoder::NodeEncoder(const Observer& d65)
    : daylight_(d65),
      sRGBFromXYZ_(xyzFromRGB(*findColorSpace("lin_rec709"), daylight_.white()).inverse()) {}

NodeValues NodeEncoder::encode(const Spectrum& reflectance) const {
    const Imath::V3d preview = daylight_.color(reflectance) * sRGBFromXYZ_;
    NodeValues node;
    node.value[0] = float(preview.z);
    node.value[1] = float(preview.y);
    node.value[2] = float(preview.x);
    for (std::size_t m = 0; m < reflectance.size(); ++m) {
        node.value[kPreviewSamples + m] = float(reflectance[m]);
    }
    return node;
}

}  // namespace specbake::internal
