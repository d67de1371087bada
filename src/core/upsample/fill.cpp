#include "upsample/fill.h"

#include <span>
#include <vector>

namespace specbake::internal {
namespace {

/// The nodes' spectra, solved together.
class NodeFinder {
  public:
    NodeFinder(const Grid& grid, const Imath::M33d& xyzFromGrid, const Solver& solver,
               const NodeEncoder& encoder)
        : grid_(grid), xyzFromGrid_(xyzFromGrid), solver_(solver), encoder_(encoder) {}

    void operator()(std::span<const std::uint32_t> nodes, std::span<NodeValues> values,
                    std::span<std::uint8_t> there) const {
        std::vector<XYZ> colors;
        for (const std::uint32_t node : nodes) {
            const auto [r, g, b] = grid_.position(node);
            colors.emplace_back(RGB{double(r), double(g), double(b)} * xyzFromGrid_);
        }
        std::vector<Solution> solutions(nodes.size());
        solver_.solveMany(colors, solutions);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!solutions[i].solved()) continue;
            values[i] = encoder_.encode(solutions[i].spectrum);
            there[i] = 1;
        }
    }

  private:
    const Grid& grid_;
    Imath::M33d xyzFromGrid_;
    const Solver& solver_;
    NodeEncoder encoder_;
};

}  // namespace

NodeStore filledStore(const Grid& grid, const Imath::M33d& xyzFromGrid, const Solver& solver,
                      const NodeEncoder& encoder) {
    return {grid.nodeCount(), NodeFinder(grid, xyzFromGrid, solver, encoder)};
}

}  // namespace specbake::internal
