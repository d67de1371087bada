#pragma once

#include "upsample/blend.h"
#include "upsample/fill.h"
#include "upsample/grid_margin.h"

#include <specbake/core/outside.h>

#include <array>

namespace specbake::internal {

/// A grid with what is known at its nodes: their spectra, and how far they may be trusted. Any
/// number of threads may share it.
class Lattice {
  public:
    using Point = std::array<float, 3>;

    /// The resolver must outlive it.
    Lattice(int nodes, const Imath::M33d& xyzFromGrid, const ColorResolver& resolver,
            const NodeEncoder& encoder);

    /// The spectrum at a point, as far as it is the grid's.
    struct Place {
        Mix mix;
        float margin = 0;  ///< the share of the mix; the rest is to be solved
    };
    /// At a point of the unit cube; margin 0 where a node has no spectrum.
    Place at(const Point& point);

    /// Notes the nodes that at() will ask for, so that they are found together.
    void note(const Point& point);

    Grid grid;
    GridMargin margin;
    NodeStore store;
};

/// Values of a texel that are a blend of stored ones.
NodeValues blended(const Mix& mix);

}  // namespace specbake::internal
