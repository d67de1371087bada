#include "colors/random_colors.h"

namespace specbake::bench {

double uniform(Generator& random, double low, double high) {
    return low + (high - low) * double(random() >> 11) * 0x1p-53;
}

RGB uniformRGB(Generator& random, double low, double high) {
    const double r = uniform(random, low, high);
    const double g = uniform(random, low, high);
    const double b = uniform(random, low, high);
    return {r, g, b};
}

XYZ inBox(const Solid& solid, const RGB& share) {
    const XYZ& white = solid.white();
    return {share.x * white.x, share.y * white.y, share.z * white.z};
}

std::vector<XYZ> firstInSolid(const Solid& solid, std::size_t count,
                              const std::function<XYZ()>& draw) {
    std::vector<XYZ> colors;
    while (colors.size() < count) {
        const XYZ color = draw();
        if (solid.gauge(color) <= 1) colors.push_back(color);
    }
    return colors;
}

}  // namespace specbake::bench
