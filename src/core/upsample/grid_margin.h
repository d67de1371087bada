#pragma once

#include "upsample/grid.h"

#include <specbake/core/solid.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace specbake::internal {

/// How far a grid may be trusted where the boundary of the object-colour solid cuts its cells.
///
/// A node has margin 1 if it and every node that shares a tetrahedron with it lie in the solid,
/// else 0. Interpolated between nodes, the margin is continuous, and 0 wherever a tetrahedron has a
/// corner outside: a blend of the grid's spectrum (margin) with the directly solved one (the rest)
/// is exact, bounded and continuous. Each node is looked at when it is first asked for.
class GridMargin {
  public:
    /// The grid and the solid must outlive it.
    GridMargin(const Grid& grid, const Imath::M33d& xyzFromGrid, const Solid& solid);

    /// Whether it is 1 everywhere.
    bool wholeCube() const { return wholeCube_; }

    /// The margin at the point of a simplex, in [0, 1].
    float at(const GridSimplex& simplex);

  private:
    enum Knowledge : std::uint8_t { inside = 1, outside = 2, trusted = 4, doubtful = 8 };

    bool isInside(int i, int j, int k);
    bool neighborhoodIsInside(std::uint32_t node);
    float ofNode(std::uint32_t node);

    const Grid& grid_;
    Imath::M33d xyzFromGrid_;
    const Solid& solid_;
    bool wholeCube_;  ///< the solid is convex: it holds the cube if it holds the corners
    /// Of each node, what is known: bits of Knowledge.
    std::unique_ptr<std::atomic<std::uint8_t>[]> known_;
};

}  // namespace specbake::internal
