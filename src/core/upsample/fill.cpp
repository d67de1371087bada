#include "upsample/fill.h"

namespace specbake::internal {

NodeStore filledStore(const Grid& grid, const Imath::M33d& xyzFromGrid, const Solver& solver) {
    const auto find = [&grid, &solver, xyzFromGrid, encoder = NodeEncoder()](std::uint32_t node,
                                                                             NodeValues& values) {
        const auto [r, g, b] = grid.position(node);
        const RGB point{double(r), double(g), double(b)};
        const Solution solution = solver.solve(XYZ(point * xyzFromGrid));
        if (!solution.solved()) return false;
        values = encoder.encode(solution.spectrum);
        return true;
    };
    return {grid.nodeCount(), find};
}

}  // namespace specbake::internal
