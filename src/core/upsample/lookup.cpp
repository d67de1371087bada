#include "upsample/lookup.h"

#include <specbake/core/ciede2000.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

using Color = SpectrumLookup::Color;

bool isFinite(const Color& color) {
    return std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
}

bool isInUnitCube(const Color& color) {
    bool inside = true;
    for (const float v : color) inside = inside & (v >= 0) & (v <= 1);
    return inside;
}

/// (1 - weight) a + weight b
NodeValues mixed(const NodeValues& a, const float* b, float weight) {
    NodeValues result;
    for (std::size_t p = 0; p < kTexelSamples; ++p) {
        result.value[p] = (1 - weight) * a.value[p] + weight * b[p];
    }
    return result;
}

NodeValues blended(const Mix& mix) {
    NodeValues result;
    for (std::size_t p = 0; p < kTexelSamples; ++p) {
        for (std::size_t k = 0; k < 4; ++k) {
            result.value[p] += mix.weights[k] * mix.values[k][p];
        }
    }
    return result;
}

NodeValues difference(const NodeValues& a, const NodeValues& b) {
    NodeValues result;
    for (std::size_t p = 0; p < kTexelSamples; ++p) result.value[p] = a.value[p] - b.value[p];
    return result;
}

/// The most of a step that keeps a spectrum within [0, 1].
float room(const NodeValues& values, const NodeValues& step) {
    float most = 1;
    for (std::size_t p = kPreviewSamples; p < kTexelSamples; ++p) {
        const float v = values.value[p];
        const float d = step.value[p];
        if (v + d > 1) most = std::min(most, (1 - v) / d);
        if (v + d < 0) most = std::min(most, -v / d);
    }
    return most;
}

bool hasSpectrum(const SolvedTexel& texel) {
    return texel.fate == Fate::solved || texel.fate == Fate::moved;
}

}  // namespace

SpectrumLookup::Lattice::Lattice(int nodes, const Imath::M33d& xyzFromGrid,
                                 const ColorResolver& resolver)
    : grid(nodes),
      margin(grid, xyzFromGrid, resolver.solid()),
      store(filledStore(grid, xyzFromGrid, resolver.solver())) {}

SpectrumLookup::SpectrumLookup(std::optional<int> gridNodes, const LookupSpaces& spaces,
                               const ColorResolver& resolver)
    : spaces_(spaces), resolver_(resolver) {
    if (!spaces.sameSpace()) gridFromTexel_ = spaces.xyzFromTexel * spaces.xyzFromGrid.inverse();
    if (gridNodes) lattice_ = std::make_unique<Lattice>(*gridNodes, spaces.xyzFromGrid, resolver);
}

void SpectrumLookup::locate(std::span<const Color> colors, std::span<Mix> mixes, Scratch& scratch,
                            ColorCensus& census) {
    for (std::size_t i = 0; i < colors.size(); i += kRun) {
        const std::size_t count = std::min(kRun, colors.size() - i);
        ColorCensus met;
        locateRun(colors.subspan(i, count), mixes.data() + i, scratch, met);
        census.add(met, i);
    }
}

/// A run as long as its places in the grid may stand on the stack.
void SpectrumLookup::locateRun(std::span<const Color> colors, Mix* mixes, Scratch& scratch,
                               ColorCensus& census) {
    std::array<std::array<std::uint32_t, 4>, kRun> nodes;
    std::array<std::array<float, 4>, kRun> weights;
    const bool wholly = lattice_ && !gridFromTexel_ && lattice_->margin.wholeCube();
    const bool allInCube = wholly && lattice_->grid.locate(colors, nodes, weights);
    Found found;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const bool inCube = allInCube || (wholly && isInUnitCube(colors[i]));
        if (inCube && lattice_->store.at(nodes[i], mixes[i].values)) {
            mixes[i].weights = weights[i];
            continue;
        }
        if (i == 0 || colors[i] != colors[i - 1]) found = find(colors[i], scratch);
        mixes[i] = found.mix;
        if (found.solved) census.meet(i, found.solved->fate, found.solved->difference);
    }
}

void SpectrumLookup::solveNodes() {
    const std::size_t count = lattice_ ? lattice_->grid.nodeCount() : 0;
    for (std::size_t node = 0; node < count; ++node) lattice_->store.at(std::uint32_t(node));
}

SpectrumLookup::Found SpectrumLookup::find(const Color& color, Scratch& scratch) {
    const Color point = gridPoint(color);
    const Place place = lattice_ && isInUnitCube(point) ? placeInGrid(point) : Place{};
    if (place.margin == 1) return {place.mix};
    SolvedTexel& solved = scratch.emplace_back(solve(color));
    if (place.margin > 0) {
        const NodeValues inGrid = blended(place.mix);
        solved.values = mixed(solved.values, inGrid.value.data(), place.margin);
    }
    return {only(solved.values.value.data()), &solved};
}

Color SpectrumLookup::gridPoint(const Color& color) const {
    if (!gridFromTexel_) return color;
    const Imath::V3d texel{double(color[0]), double(color[1]), double(color[2])};
    const Imath::V3d point = texel * *gridFromTexel_;
    return {float(point.x), float(point.y), float(point.z)};
}

SpectrumLookup::Place SpectrumLookup::placeInGrid(const Color& point) {
    const GridSimplex simplex = lattice_->grid.locate(point);
    Place place;
    place.margin = lattice_->margin.at(simplex);
    if (place.margin == 0) return place;
    place.mix.weights = simplex.weight;
    if (!lattice_->store.at(simplex.node, place.mix.values)) return {};
    return place;
}

SolvedTexel SpectrumLookup::solve(const Color& color) {
    if (!isFinite(color)) return {{}, Fate::notFinite, 0};
    if (const auto known = cache_.find(color)) return *known;
    const SolvedTexel solved = solveAnew(color);
    cache_.store(color, solved);
    return solved;
}

SolvedTexel SpectrumLookup::solveAnew(const Color& color) {
    const RGB rgb{double(color[0]), double(color[1]), double(color[2])};
    SolvedTexel solved = solveColor(XYZ(rgb * spaces_.xyzFromTexel));
    const Color point = gridPoint(color);
    if (lattice_ && hasSpectrum(solved) && !isInUnitCube(point)) addFaceStep(point, solved.values);
    return solved;
}

SolvedTexel SpectrumLookup::solveColor(const XYZ& asked) const {
    const ColorResolver::Resolved resolved = resolver_.resolve(asked);
    if (!resolved.solution.solved()) {
        return {{}, resolved.outside ? Fate::refused : Fate::failed, 0};
    }
    const NodeValues values = encoder_.encode(resolved.solution.spectrum);
    if (!resolved.outside) return {values, Fate::solved, 0};
    const XYZ& white = resolver_.solid().white();
    return {values, Fate::moved,
            ciede2000(labFromXYZ(asked, white), labFromXYZ(resolved.given, white))};
}

/// Adds what the grid's spectrum has beyond the solved one at the nearest point of the cube: all of
/// it at the cube's face, less and less farther out, and nowhere more than keeps within [0, 1].
/// Both have the same colour, so that the sum keeps its own.
void SpectrumLookup::addFaceStep(const Color& point, NodeValues& values) {
    constexpr float fadedOut = 1.0F / 16;  // distance, linear RGB
    Color onFace = point;
    float distance = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        onFace[c] = std::clamp(point[c], 0.0F, 1.0F);
        distance = std::max(distance, std::abs(point[c] - onFace[c]));
    }
    if (distance >= fadedOut) return;
    const Place place = placeInGrid(onFace);
    if (place.margin == 0) return;
    const RGB rgb{double(onFace[0]), double(onFace[1]), double(onFace[2])};
    const SolvedTexel solved = solveColor(XYZ(rgb * spaces_.xyzFromGrid));
    if (!hasSpectrum(solved)) return;
    const NodeValues step = difference(blended(place.mix), solved.values);
    const float share = std::min(place.margin * (1 - distance / fadedOut), room(values, step));
    for (std::size_t p = 0; p < kTexelSamples; ++p) values.value[p] += share * step.value[p];
}

}  // namespace specbake::internal
