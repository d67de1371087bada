#include "sample_colors.h"

#include <specbake/core/color_space.h>

#include <algorithm>
#include <cmath>

namespace specbake::testing {

SampleColors::SampleColors(const Observer& observer, unsigned seed)
    : white_(observer.white()),
      fromRGB_(xyzFromRGB(*findColorSpace("lin_rec709"), observer.white())),
      random_(seed) {
    const auto& w = observer.weights();
    for (std::size_t m = 0; m < w.size(); ++m) {
        for (std::size_t k = m + 1; k < w.size(); ++k) {
            const Imath::V3d normal = w[m].cross(w[k]);
            // parallel but for rounding: no face
            if (normal.length() < 1e-9 * w[m].length() * w[k].length()) continue;
            double width = 0;
            for (const Imath::V3d& v : w) width += std::abs(normal.dot(v));
            faces_.push_back({normal, width / 2});
        }
    }
}

XYZ SampleColors::sRGB(double top) {
    const double r = uniform(), g = uniform(), b = uniform();
    return XYZ(Imath::V3d(r, g, b) * top * fromRGB_);
}

XYZ SampleColors::atGauge(double gauge) {
    for (;;) {
        const double x = uniform(), y = uniform(), z = uniform();
        const Imath::V3d offset = white_ * Imath::V3d(x - 0.5, y - 0.5, z - 0.5);
        const double own = gaugeOf(offset);
        if (own <= 1) return XYZ(white_ * 0.5 + offset * (gauge / own));
    }
}

double SampleColors::gaugeOf(const Imath::V3d& offset) const {
    double largest = 0;
    for (const Face& face : faces_) {
        largest = std::max(largest, std::abs(face.normal.dot(offset)) / face.halfWidth);
    }
    return largest;
}

}  // namespace specbake::testing
