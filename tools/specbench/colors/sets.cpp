#include "colors/sets.h"

#include "colors/random_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>

namespace specbake::bench {
namespace {

constexpr std::uint64_t kSeed = 20;

ColorSet drawn(std::string name, const Frame& frame, std::size_t count,
               const std::function<RGB(Generator&)>& draw) {
    Generator random(kSeed);
    ColorSet set{.name = std::move(name), .colors = {}};
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
    if (count >= all.size()) return {.name = "8-bit lattice", .colors = all};
    ColorSet set{.name = "8-bit lattice", .colors = {}};  // evenly thinned
    const double stride = double(all.size() - 1) / double(count - 1);
    for (std::size_t i = 0; i < count; ++i)
        set.colors.push_back(all[std::size_t(double(i) * stride)]);
    return set;
}

/// Where the ray towards a random point of the box about the solid leaves it.
XYZ boundaryColor(const Solid& solid, Generator& random) {
    const XYZ color = inBox(solid, uniformRGB(random, 0, 1));
    return XYZ(solid.center() + (color - solid.center()) / solid.gauge(color));
}

ColorSet uniformInSolid(const Solid& solid, std::size_t count) {
    Generator random(kSeed);
    const auto draw = [&] { return inBox(solid, uniformRGB(random, 0, 1)); };
    return {.name = "solid", .colors = firstInSolid(solid, count, draw)};
}

ColorSet cubeInSolid(std::string name, const char* space, const Frame& frame, const Solid& solid,
                     std::size_t count) {
    const Imath::M33d matrix = xyzFromRGB(*findColorSpace(space), frame.observer.white());
    Generator random(kSeed);
    const auto draw = [&] { return XYZ(uniformRGB(random, 0, 1) * matrix); };
    return {.name = std::move(name), .colors = firstInSolid(solid, count, draw)};
}

ColorSet justOutside(const Solid& solid, std::size_t count) {
    Generator random(kSeed);
    ColorSet set{.name = "just outside", .colors = {}};
    for (std::size_t i = 0; i < count; ++i) {
        const Imath::V3d arm = boundaryColor(solid, random) - solid.center();
        set.colors.emplace_back(solid.center() + arm * uniform(random, 1, 1.05));
    }
    return set;
}

}  // namespace

std::vector<XYZ> colorsAtGauge(const Solid& solid, double gauge, std::size_t count) {
    Generator random(kSeed);
    std::vector<XYZ> colors;
    for (std::size_t i = 0; i < count; ++i) {
        const Imath::V3d arm = boundaryColor(solid, random) - solid.center();
        colors.emplace_back(solid.center() + arm * gauge);
    }
    return colors;
}

std::vector<ColorSet> solidSets(const Frame& frame, const Solid& solid, std::size_t count) {
    constexpr std::size_t shares = 20'000;  // of which a share is known to 0.4 %
    std::vector<ColorSet> sets{uniformInSolid(solid, std::max(count, shares))};
    for (const double gauge : {0.9, 0.99, 0.999, 0.9999, 1.0}) {
        sets.push_back(
            {.name = fmt::format("gauge {}", gauge), .colors = colorsAtGauge(solid, gauge, count)});
    }
    sets.push_back(cubeInSolid("Rec.2020 cube", "lin_rec2020", frame, solid, count));
    sets.push_back(cubeInSolid("ACEScg cube", "acescg", frame, solid, count));
    sets.push_back(justOutside(solid, count / 10));
    return sets;
}

std::vector<ColorSet> rgbSets(const Frame& frame, std::size_t count) {
    const std::size_t few = count / 10;
    std::vector<ColorSet> sets{
        drawn("RGB cube", frame, count, [](Generator& g) { return uniformRGB(g, 0, 1); }),
        lattice(frame, count),
        drawn("dark", frame, few, [](Generator& g) { return uniformRGB(g, 0, 0.05); }),
        drawn("near black, saturated", frame, few, faintSaturated),
        drawn("near white", frame, few, [](Generator& g) { return uniformRGB(g, 0.99, 1); })};
    sets[3].neighbour = 1e-6;  // small beside the colours
    return sets;
}

}  // namespace specbake::bench
