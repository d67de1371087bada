#include "grid_method.h"

#include "clones.h"

#include <algorithm>

namespace specbake::bench {
namespace {

SPECBENCH_CLONES
void blend(const std::array<const float*, 4>& node, const std::array<float, 4>& weight,
           float* out) {
    for (int m = 0; m < kBandCount; ++m) {
        out[m] = weight[0] * node[0][m] + weight[1] * node[1][m] + weight[2] * node[2][m] +
                 weight[3] * node[3][m];
    }
}

MethodName named(MethodName solver, int nodes) {
    const std::string grid = "grid " + std::to_string(nodes);
    solver.parameters = solver.parameters.empty() ? grid : solver.parameters + ", " + grid;
    return solver;
}

bool inUnitCube(const RGB& c) {
    const double rounding = 1e-7;  // of XYZ -> RGB, and of the float that the grid takes
    return std::min({c.x, c.y, c.z}) >= -rounding && std::max({c.x, c.y, c.z}) <= 1 + rounding;
}

float unit(double v) {
    return std::clamp(static_cast<float>(v), 0.0F, 1.0F);
}

}  // namespace

GridMethod::GridMethod(MethodName solver, Frame frame, std::shared_ptr<const Solver> direct,
                       int nodes)
    : Method(named(std::move(solver), nodes), std::move(frame)),
      solver_(std::move(direct)),
      grid_(nodes) {}

XYZ GridMethod::nodeColor(std::uint32_t node) const {
    const auto p = grid_.position(node);
    return frame().xyz(RGB(double(p[0]), double(p[1]), double(p[2])));
}

void GridMethod::setUp() {
    nodes_.resize(grid_.nodeCount());
    failedNodes_ = 0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const Solution solution = solver_->solve(nodeColor(std::uint32_t(n)));
        failedNodes_ += !solution.solved();
        std::ranges::transform(solution.spectrum, nodes_[n].begin(),
                               [](double v) { return static_cast<float>(v); });
    }
}

Reconstruction GridMethod::reconstruct(const XYZ& color) const {
    const RGB rgb = frame().rgb(color);
    if (!inUnitCube(rgb)) {
        const Solution solution = solver_->solve(color);
        return {solution.spectrum, solution.solved()};
    }
    const Imath::V3f texel(unit(rgb.x), unit(rgb.y), unit(rgb.z));
    Node spectrum;
    reconstructTexels({&texel, 1}, spectrum);
    Reconstruction r;
    std::ranges::copy(spectrum, r.spectrum.begin());
    return r;
}

void GridMethod::reconstructTexels(std::span<const Imath::V3f> rgb,
                                   std::span<float> spectra) const {
    float* out = spectra.data();
    for (const Imath::V3f& texel : rgb) {
        const GridSimplex at = grid_.locate({texel.x, texel.y, texel.z});
        blend({nodes_[at.node[0]].data(), nodes_[at.node[1]].data(), nodes_[at.node[2]].data(),
               nodes_[at.node[3]].data()},
              at.weight, out);
        out += kBandCount;
    }
}

}  // namespace specbake::bench
