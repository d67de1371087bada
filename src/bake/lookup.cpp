#include "lookup.h"

#include <algorithm>
#include <cmath>

namespace specbake {
namespace {

using Color = std::array<float, 3>;

bool isFinite(const Color& color) {
    return std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
}

bool isInUnitCube(const Color& color) {
    return std::all_of(color.begin(), color.end(), [](float v) { return v >= 0 && v <= 1; });
}

}  // namespace

SpectrumLookup::SpectrumLookup(int gridNodes, const Imath::M33d& xyzFromTexel, const Solver& solver)
    : grid_(gridNodes),
      xyzFromTexel_(xyzFromTexel),
      solver_(solver),
      store_(filledStore(grid_, xyzFromTexel, solver)) {}

void SpectrumLookup::locate(std::span<const Color> colors, std::size_t firstTexel,
                            std::span<Mix> mixes, Scratch& scratch, TexelCensus& census) {
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (i > 0 && colors[i] == colors[i - 1]) {
            mixes[i] = mixes[i - 1];
        } else if (!isInUnitCube(colors[i]) || !locateInGrid(colors[i], mixes[i])) {
            mixes[i] = solve(colors[i], firstTexel + i, scratch, census);
        }
    }
}

bool SpectrumLookup::locateInGrid(const Color& color, Mix& mix) {
    const GridSimplex simplex = grid_.locate(color);
    for (std::size_t k = 0; k < 4; ++k) {
        mix.values[k] = store_.at(simplex.node[k]);
        if (mix.values[k] == nullptr) return false;
    }
    mix.weights = simplex.weight;
    return true;
}

Mix SpectrumLookup::solve(const Color& color, std::size_t texel, Scratch& scratch,
                          TexelCensus& census) const {
    static constexpr NodeValues black{};
    if (!isFinite(color)) {
        census.notFinite.meet(texel);
        return only(black.value.data());
    }
    const RGB rgb{double(color[0]), double(color[1]), double(color[2])};
    const Solution solution = solver_.solve(XYZ(rgb * xyzFromTexel_));
    if (!solution.solved()) {
        census.outside.meet(texel);
        return only(black.value.data());
    }
    ++census.direct;
    scratch.push_back(encoder_.encode(solution.spectrum));
    return only(scratch.back().value.data());
}

}  // namespace specbake
