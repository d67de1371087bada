#include "upsample/lattice.h"

namespace specbake::internal {

NodeValues blended(const Mix& mix) {
    NodeValues result;
    for (std::size_t p = 0; p < kTexelSamples; ++p) {
        for (std::size_t k = 0; k < 4; ++k) {
            result.value[p] += mix.weights[k] * mix.values[k][p];
        }
    }
    return result;
}

Lattice::Lattice(int nodes, const Imath::M33d& xyzFromGrid, const ColorResolver& resolver,
                 const NodeEncoder& encoder)
    : grid(nodes),
      margin(grid, xyzFromGrid, resolver.solid()),
      store(filledStore(grid, xyzFromGrid, resolver.solver(), encoder)) {}

Lattice::Place Lattice::at(const Point& point) {
    const GridSimplex simplex = grid.locate(point);
    Place place;
    place.margin = margin.at(simplex);
    if (place.margin == 0) return place;
    place.mix.weights = simplex.weight;
    if (!store.at(simplex.node, place.mix.values)) return {};
    return place;
}

void Lattice::note(const Point& point) {
    const GridSimplex simplex = grid.locate(point);
    if (margin.at(simplex) > 0) store.note(simplex.node);
}

}  // namespace specbake::internal
