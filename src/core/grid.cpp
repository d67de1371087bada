#include <specbake/core/error.h>
#include <specbake/core/grid.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace specbake {

GridAxis::GridAxis(int nodes) {
    if (nodes < kFewestNodes || nodes > kMostNodes) {
        throw ArgumentError("a grid has 2 to 129 nodes an axis, not " + std::to_string(nodes));
    }
    cells_ = float(nodes - 1);
    for (int i = 0; i < nodes; ++i) {
        const double u = double(i) / (nodes - 1);
        position_.push_back(float(u * u));
    }
    for (int i = 0; i + 1 < nodes; ++i) {
        inverseWidth_.push_back(float(1 / (double(position(i + 1)) - double(position(i)))));
    }
}

GridAxis::Place GridAxis::locate(float coordinate) const {
    const float u = std::sqrt(std::clamp(coordinate, 0.0F, 1.0F)) * cells_;
    int cell = std::min(int(u), nodes() - 2);
    // The root is rounded: the node decides.
    if (coordinate < position(cell) && cell > 0) --cell;
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

}  // namespace specbake
