#pragma once

#include "upsample/grid.h"
#include "upsample/node_store.h"
#include "upsample/node_values.h"

#include <specbake/core/solver.h>

namespace specbake::internal {

/// Where grid and solvers meet: a store of the grid's nodes, solved when first asked for.
/// A node has no values where the solver does not solve its colour. The grid and the solver must
/// outlive the store. `xyzFromGrid`: a grid point's colour is XYZ(point * xyzFromGrid).
NodeStore filledStore(const Grid& grid, const Imath::M33d& xyzFromGrid, const Solver& solver,
                      const NodeEncoder& encoder);

}  // namespace specbake::internal
