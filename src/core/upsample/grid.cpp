#include "upsample/grid.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace specbake::internal {

GridAxis::GridAxis(int nodes) : nodes_(nodes) {
    if (nodes < kFewestGridNodes || nodes > kMostGridNodes) {
        throw ArgumentError("a grid of " + std::to_string(nodes) + " nodes an axis");
    }
    position_.resize(std::max(std::size_t(nodes), kShortestTable));
    for (int i = 0; i < nodes; ++i) {
        const double u = double(i) / (nodes - 1);
        position_[std::size_t(i)] = float(u * u);
    }
    inverseWidth_.resize(position_.size());
    for (int i = 0; i + 1 < nodes; ++i) {
        const double width = double(position(i + 1)) - double(position(i));
        inverseWidth_[std::size_t(i)] = float(1 / width);
    }
}

GridAxis::Place GridAxis::locate(float coordinate) const {
    const float u = std::sqrt(std::clamp(coordinate, 0.0F, 1.0F)) * cells();
    const int cell = std::min(int(u), nodes() - 2);
    // Below 0 by a rounding error where the root was rounded up to the node: then at the node.
    const float fraction = (coordinate - position(cell)) * inverseWidth_[std::size_t(cell)];
    return {cell, std::clamp(fraction, 0.0F, 1.0F)};
}

std::size_t Grid::nodeCount() const {
    const auto n = std::size_t(axis_.nodes());
    return n * n * n;
}

std::uint32_t Grid::node(int i, int j, int k) const {
    const int n = axis_.nodes();
    return std::uint32_t((i * n + j) * n + k);
}

std::array<float, 3> Grid::position(std::uint32_t node) const {
    const auto n = std::uint32_t(axis_.nodes());
    return {axis_.position(int(node / n / n)), axis_.position(int(node / n % n)),
            axis_.position(int(node % n))};
}

GridSimplex Grid::locate(const std::array<float, 3>& point) const {
    const auto n = std::uint32_t(axis_.nodes());
    const std::array<GridAxis::Place, 3> place = {axis_.locate(point[0]), axis_.locate(point[1]),
                                                  axis_.locate(point[2])};
    // From the cell's lowest corner to its highest, one axis at a time, largest fraction first.
    struct Edge {
        float fraction;
        std::uint32_t stride;
    };
    Edge first{place[0].fraction, n * n};
    Edge second{place[1].fraction, n};
    Edge third{place[2].fraction, 1};
    if (first.fraction < second.fraction) std::swap(first, second);
    if (second.fraction < third.fraction) std::swap(second, third);
    if (first.fraction < second.fraction) std::swap(first, second);

    const std::uint32_t corner = node(place[0].cell, place[1].cell, place[2].cell);
    return {{corner, corner + first.stride, corner + first.stride + second.stride,
             corner + first.stride + second.stride + third.stride},
            {1 - first.fraction, first.fraction - second.fraction, second.fraction - third.fraction,
             third.fraction}};
}

}  // namespace specbake::internal
