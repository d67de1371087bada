#include "upsample/lookup.h"

#include "upsample/distinct_colors.h"

#include <algorithm>

namespace specbake::internal {
namespace {

/// (1 - weight) a + weight b
NodeValues mixed(const NodeValues& a, const NodeValues& b, float weight) {
    NodeValues result;
    for (std::size_t p = 0; p < kTexelSamples; ++p) {
        result.value[p] = (1 - weight) * a.value[p] + weight * b.value[p];
    }
    return result;
}

}  // namespace

SpectrumLookup::SpectrumLookup(std::optional<int> gridNodes, const LookupSpaces& spaces,
                               const ColorResolver& resolver, const NodeEncoder& encoder)
    : spaces_(spaces),
      lattice_(gridNodes
                   ? std::make_unique<Lattice>(*gridNodes, spaces.xyzFromGrid(), resolver, encoder)
                   : nullptr),
      texels_(spaces_, resolver, encoder, lattice_.get()) {}

void SpectrumLookup::locate(std::span<const Color> colors, std::span<Mix> mixes, Scratch& scratch,
                            ColorCensus& census) {
    for (std::size_t i = 0; i < colors.size(); i += kTogether) {
        const std::size_t count = std::min(kTogether, colors.size() - i);
        ColorCensus met;
        locateTogether(colors.subspan(i, count), mixes.data() + i, scratch, met);
        census.add(met, i);
    }
}

void SpectrumLookup::locateTogether(std::span<const Color> colors, Mix* mixes, Scratch& scratch,
                                    ColorCensus& census) {
    std::vector<std::size_t> missing;
    if (lattice_) {
        for (std::size_t i = 0; i < colors.size(); i += kRun) {
            locateRun(colors.subspan(i, std::min(kRun, colors.size() - i)), i, mixes, missing);
        }
    } else {
        for (std::size_t i = 0; i < colors.size(); ++i) missing.push_back(i);
    }
    if (!missing.empty()) findMissing(colors, missing, mixes, scratch, census);
}

void SpectrumLookup::placesOf(std::span<const Color> colors, Places& places) const {
    std::transform(colors.begin(), colors.end(), places.points.begin(),
                   [this](const Color& color) { return spaces_.gridPoint(color); });
    const std::span<const Color> points(places.points.data(), colors.size());
    const bool allInCube = lattice_->grid.locate(points, places.nodes, places.weights);
    for (std::size_t i = 0; i < points.size(); ++i) {
        places.inCube[i] = allInCube || isInUnitCube(points[i]);
    }
}

/// What the grid alone gives, as far as its nodes are known; the others are missing.
void SpectrumLookup::locateRun(std::span<const Color> colors, std::size_t first, Mix* mixes,
                               std::vector<std::size_t>& missing) {
    Places places;
    placesOf(colors, places);
    const bool whole = lattice_->margin.wholeCube();
    for (std::size_t i = 0; i < colors.size(); ++i) {
        Mix& mix = mixes[first + i];
        const bool trusted =
            places.inCube[i] &&
            (whole || lattice_->margin.at({places.nodes[i], places.weights[i]}) == 1);
        if (trusted && lattice_->store.present(places.nodes[i], mix.values)) {
            mix.weights = places.weights[i];
        } else {
            missing.push_back(first + i);
        }
    }
}

void SpectrumLookup::findMissing(std::span<const Color> colors,
                                 std::span<const std::size_t> missing, Mix* mixes, Scratch& scratch,
                                 ColorCensus& census) {
    const DistinctColors distinct(colors, missing);
    const std::vector<Found> found = find(distinct.colors, scratch);
    for (std::size_t m = 0; m < missing.size(); ++m) {
        const Found& f = found[distinct.number[m]];
        mixes[missing[m]] = f.mix;
        if (f.solved != nullptr) census.meet(missing[m], f.solved->fate, f.solved->difference);
    }
}

/// First the grid's part of all of them, then what is to be solved.
std::vector<SpectrumLookup::Found> SpectrumLookup::find(std::span<const Color> colors,
                                                        Scratch& scratch) {
    const std::vector<Lattice::Place> places = placesInGrid(colors);
    std::vector<Found> found(colors.size());
    std::vector<std::size_t> apart;
    std::vector<Color> alone;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        found[i].mix = places[i].mix;
        if (places[i].margin == 1) continue;
        apart.push_back(i);
        alone.push_back(colors[i]);
    }
    std::vector<SolvedTexel> solved(alone.size());
    texels_.solve(alone, solved);
    for (std::size_t k = 0; k < apart.size(); ++k) {
        const Lattice::Place& place = places[apart[k]];
        SolvedTexel& texel = scratch.emplace_back(solved[k]);
        if (place.margin > 0) {
            texel.values = mixed(texel.values, blended(place.mix), place.margin);
        }
        found[apart[k]] = {only(texel.values.value.data()), &texel};
    }
    return found;
}

/// Margin 0 for those beyond the cube; the nodes that are missing are found together.
std::vector<Lattice::Place> SpectrumLookup::placesInGrid(std::span<const Color> colors) {
    std::vector<Lattice::Place> places(colors.size());
    if (!lattice_) return places;
    std::vector<Color> points;
    for (const Color& color : colors) {
        points.push_back(spaces_.gridPoint(color));
        if (isInUnitCube(points.back())) lattice_->note(points.back());
    }
    lattice_->store.findNoted();
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (isInUnitCube(points[i])) places[i] = lattice_->at(points[i]);
    }
    return places;
}

void SpectrumLookup::noteNodes(std::span<const Color> colors) {
    if (!lattice_) return;
    for (std::size_t first = 0; first < colors.size(); first += kRun) {
        const std::size_t count = std::min(kRun, colors.size() - first);
        Places places;
        placesOf(colors.subspan(first, count), places);
        for (std::size_t i = 0; i < count; ++i) {
            const bool wanted =
                places.inCube[i] && lattice_->margin.at({places.nodes[i], places.weights[i]}) > 0;
            if (wanted) lattice_->store.note(places.nodes[i]);
        }
    }
}

void SpectrumLookup::noteAllNodes() {
    const std::size_t count = lattice_ ? lattice_->grid.nodeCount() : 0;
    for (std::size_t node = 0; node < count; ++node) lattice_->store.note(std::uint32_t(node));
}

void SpectrumLookup::solveNotedNodes() {
    if (lattice_) lattice_->store.findNoted();
}

}  // namespace specbake::internal
