#include "method.h"

namespace specbake::bench {

void Method::reconstructTexels(std::span<const Imath::V3f> rgb, std::span<float> spectra) const {
    float* out = spectra.data();
    for (const Imath::V3f& texel : rgb) {
        const Reconstruction r = reconstruct(frame_.xyz(RGB(texel.x, texel.y, texel.z)));
        for (const double value : r.spectrum) *out++ = static_cast<float>(value);
    }
}

}  // namespace specbake::bench
