#include "sets.h"

#include <cstdint>
#include <functional>
#include <random>

namespace specbake::bench {
namespace {

using Generator = std::mt19937_64;

constexpr std::uint64_t kSeed = 20;

/// A double in [low, high) from the 53 high bits: std::uniform_real_distribution may differ
/// between libraries.
double uniform(Generator& random, double low, double high) {
    return low + (high - low) * double(random() >> 11) * 0x1p-53;
}

RGB uniformRGB(Generator& random, double low, double high) {
    const double r = uniform(random, low, high);
    const double g = uniform(random, low, high);
    const double b = uniform(random, low, high);
    return {r, g, b};
}

ColorSet drawn(std::string name, const Frame& frame, std::size_t count,
               const std::function<RGB(Generator&)>& draw) {
    Generator random(kSeed);
    ColorSet set{std::move(name), {}};
    for (std::size_t i = 0; i < count; ++i) set.colors.push_back(frame.xyz(draw(random)));
    return set;
}

/// One or two components in [0, limit], the rest 0: the six saturated hues, faint.
RGB faintSaturated(Generator& random) {
    constexpr double limit = 1e-4;
    RGB color = uniformRGB(random, 0, limit);
    const std::size_t hue = random() % 6;
    color[int(hue % 3)] = 0;
    if (hue >= 3) color[int((hue + 1) % 3)] = 0;
    return color;
}

ColorSet lattice(const Frame& frame, std::size_t count) {
    constexpr int step = 5;
    std::vector<XYZ> all;
    for (int r = 0; r <= 255; r += step) {
        for (int g = 0; g <= 255; g += step) {
            for (int b = 0; b <= 255; b += step) {
                all.push_back(frame.xyz({linearFromSRGB(r / 255.0), linearFromSRGB(g / 255.0),
                                         linearFromSRGB(b / 255.0)}));
            }
        }
    }
    if (count >= all.size()) return {"8-bit lattice", all};
    ColorSet set{"8-bit lattice", {}};  // evenly thinned
    const double stride = double(all.size() - 1) / double(count - 1);
    for (std::size_t i = 0; i < count; ++i)
        set.colors.push_back(all[std::size_t(double(i) * stride)]);
    return set;
}

}  // namespace

std::vector<ColorSet> rgbSets(const Frame& frame, std::size_t count) {
    return {drawn("RGB cube", frame, count, [](Generator& g) { return uniformRGB(g, 0, 1); }),
            lattice(frame, count),
            drawn("dark", frame, count, [](Generator& g) { return uniformRGB(g, 0, 0.05); }),
            drawn("near black, saturated", frame, count, faintSaturated),
            drawn("near white", frame, count, [](Generator& g) { return uniformRGB(g, 0.99, 1); })};
}

}  // namespace specbake::bench
