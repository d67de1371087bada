#pragma once

#include "method.h"
#include "upsample/grid.h"

#include <specbake/core/solver.h>

#include <array>
#include <memory>
#include <vector>

namespace specbake::bench {

/// A solver of specbake through the lookup grid over the frame's RGB cube (grid.h): all nodes
/// solved and stored as floats, a texel is the blend of four of them. Colours outside the cube are
/// solved directly, as specbake does.
///
/// | quantity | domain    | scale                                        |
/// |----------|-----------|----------------------------------------------|
/// | RGB      | any       | linear; the grid holds [0, 1]                |
/// | spectrum | as solver | floats: exact to 24 bits                     |
class GridMethod : public Method {
  public:
    /// `solvers` names the family; nodes an axis as Grid takes them.
    GridMethod(MethodName solver, Frame frame, std::shared_ptr<const Solver> direct, int nodes);

    void setUp() override;
    bool cubeOnly() const override { return true; }  // outside, it is the solver
    Reconstruction reconstruct(const XYZ& color) const override;
    void reconstructTexels(std::span<const Imath::V3f> rgb,
                           std::span<float> spectra) const override;

    /// Memory of all nodes.
    std::size_t bytes() const { return nodes_.size() * sizeof(Node); }
    /// Nodes that the solver could not solve; 0 before setUp().
    int failedNodes() const { return failedNodes_; }

  private:
    struct alignas(64) Node {
        std::array<float, 96> value{};  ///< kBandCount of them, up to whole cache lines
    };
    XYZ nodeColor(std::uint32_t node) const;

    std::shared_ptr<const Solver> solver_;
    Grid grid_;
    std::vector<Node> nodes_;
    int failedNodes_ = 0;
};

}  // namespace specbake::bench
