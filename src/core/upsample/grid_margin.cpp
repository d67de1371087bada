#include "upsample/grid_margin.h"

#include <algorithm>
#include <initializer_list>

namespace specbake::internal {

GridMargin::GridMargin(const Grid& grid, const Imath::M33d& xyzFromGrid, const Solid& solid)
    : grid_(grid), xyzFromGrid_(xyzFromGrid), solid_(solid) {
    const int last = grid.axis().nodes() - 1;
    known_ = std::make_unique<std::atomic<std::uint8_t>[]>(grid.nodeCount());
    wholeCube_ = true;
    for (const int i : {0, last}) {
        for (const int j : {0, last}) {
            for (const int k : {0, last}) wholeCube_ = wholeCube_ && isInside(i, j, k);
        }
    }
    if (wholeCube_) known_.reset();
}

/// Nodes beyond the cube are nobody's corner and count as inside.
bool GridMargin::isInside(int i, int j, int k) {
    const int last = grid_.axis().nodes() - 1;
    if (std::min({i, j, k}) < 0 || std::max({i, j, k}) > last) return true;
    std::atomic<std::uint8_t>& known = known_[grid_.node(i, j, k)];
    const int seen = known.load(std::memory_order_relaxed);
    if ((seen & (inside | outside)) != 0) return (seen & inside) != 0;
    const GridAxis& axis = grid_.axis();
    const Imath::V3d point{double(axis.position(i)), double(axis.position(j)),
                           double(axis.position(k))};
    const bool contained = solid_.contains(XYZ(point * xyzFromGrid_));
    known.fetch_or(contained ? inside : outside, std::memory_order_relaxed);
    return contained;
}

/// A Kuhn tetrahedron's corners differ by steps of one sign: all up, or all down.
bool GridMargin::neighborhoodIsInside(std::uint32_t node) {
    const auto n = std::uint32_t(grid_.axis().nodes());
    const int i = int(node / n / n);
    const int j = int(node / n % n);
    const int k = int(node % n);
    for (const int sign : {-1, 1}) {
        for (int step = 0; step < 8; ++step) {
            if (!isInside(i + sign * (step & 1), j + sign * (step >> 1 & 1),
                          k + sign * (step >> 2 & 1))) {
                return false;
            }
        }
    }
    return true;
}

float GridMargin::ofNode(std::uint32_t node) {
    const int seen = known_[node].load(std::memory_order_relaxed);
    if ((seen & (trusted | doubtful)) != 0) return (seen & trusted) != 0 ? 1.0F : 0.0F;
    const bool trust = neighborhoodIsInside(node);
    known_[node].fetch_or(trust ? trusted : doubtful, std::memory_order_relaxed);
    return trust ? 1.0F : 0.0F;
}

float GridMargin::at(const GridSimplex& simplex) {
    if (wholeCube_) return 1;
    float sum = 0;
    bool all = true;
    for (std::size_t k = 0; k < 4; ++k) {
        const float margin = ofNode(simplex.node[k]);
        all = all && margin == 1;
        sum += simplex.weight[k] * margin;
    }
    return all ? 1 : sum;
}

}  // namespace specbake::internal
