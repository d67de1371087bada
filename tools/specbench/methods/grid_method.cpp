#include "grid_method.h"

#include "clones.h"

#include <algorithm>

namespace specbake::bench {
namespace {

constexpr std::size_t kRun = 256;  // texels located at a time

/// Texels of a run as blends of four nodes each.
struct Places {
    std::array<std::array<std::uint32_t, 4>, kRun> nodes;
    std::array<std::array<float, 4>, kRun> weights;
};

/// `nodes` of `stride` floats each; kBandCount of each texel, clamped as those of a bake.
SPECBENCH_CLONES
void blend(const float* nodes, std::size_t stride, const Places& places, std::size_t count,
           float* out) {
    for (std::size_t i = 0; i < count; ++i, out += kBandCount) {
        const auto& [n0, n1, n2, n3] = places.nodes[i];
        const auto [w0, w1, w2, w3] = places.weights[i];
        const float* s0 = nodes + n0 * stride;
        const float* s1 = nodes + n1 * stride;
        const float* s2 = nodes + n2 * stride;
        const float* s3 = nodes + n3 * stride;
        for (int m = 0; m < kBandCount; ++m) {
            const float s = w0 * s0[m] + w1 * s1[m] + w2 * s2[m] + w3 * s3[m];
            out[m] = s < 1 ? s : 1;
        }
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
        std::ranges::transform(solution.spectrum, nodes_[n].value.begin(),
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
    std::array<float, kBandCount> spectrum;
    reconstructTexels({&texel, 1}, spectrum);
    Reconstruction r;
    std::ranges::copy(spectrum, r.spectrum.begin());
    return r;
}

void GridMethod::reconstructTexels(std::span<const Imath::V3f> rgb,
                                   std::span<float> spectra) const {
    std::array<std::array<float, 3>, kRun> points;
    Places places;
    for (std::size_t first = 0; first < rgb.size(); first += kRun) {
        const auto some = rgb.subspan(first, std::min(kRun, rgb.size() - first));
        std::ranges::transform(some, points.begin(), [](const Imath::V3f& c) {
            return std::array{c.x, c.y, c.z};
        });
        grid_.locate(std::span(points).first(some.size()), places.nodes, places.weights);
        blend(nodes_[0].value.data(), sizeof(Node) / sizeof(float), places, some.size(),
              spectra.data() + first * kBandCount);
    }
}

}  // namespace specbake::bench
