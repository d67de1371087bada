#include "upsample/grid.h"

#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace specbake;
using namespace specbake::internal;

namespace {

std::array<double, 3> combination(const Grid& grid, const GridSimplex& simplex) {
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto p = grid.position(simplex.node[k]);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += double(simplex.weight[k]) * double(p[i]);
    }
    return sum;
}

}  // namespace

TEST_CASE("a point is the weighted sum of its four nodes, with weights of a convex combination") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const int nodes : {2, 3, 5, 17, 33, 129}) {
        const Grid grid(nodes);
        for (int trial = 0; trial < 5000; ++trial) {
            const std::array<float, 3> point = {uniform(random), uniform(random),
                                                uniform(random) * uniform(random)};
            const GridSimplex simplex = grid.locate(point);
            float total = 0;
            for (const float weight : simplex.weight) {
                CHECK(weight >= 0);
                CHECK(weight <= 1);
                total += weight;
            }
            CHECK(std::abs(total - 1) <= 3 * 0x1p-24F);  // three roundings of numbers below 1
            const auto sum = combination(grid, simplex);
            for (std::size_t i = 0; i < 3; ++i) {
                // Four roundings of the fraction (difference, inverse width, product, weight),
                // each times the cell's width, which is below 1; and of the total at the node.
                CHECK(std::abs(sum[i] - double(point[i])) <= 8 * 0x1p-24);
            }
        }
    }
}

TEST_CASE("a node is itself, whatever the resolution") {
    for (const int nodes : {2, 5, 17, 24, 129}) {
        const Grid grid(nodes);
        std::mt19937_64 random(3);
        for (int trial = 0; trial < 2000; ++trial) {
            const auto node = std::uint32_t(random() % grid.nodeCount());
            const GridSimplex simplex = grid.locate(grid.position(node));
            for (std::size_t k = 0; k < 4; ++k) {
                CHECK(simplex.weight[k] == (simplex.node[k] == node ? 1.0F : 0.0F));
            }
        }
    }
}

TEST_CASE("greys use grey nodes alone") {
    const Grid grid(17);
    for (int i = 0; i <= 1000; ++i) {
        const float g = float(i) / 1000;
        const GridSimplex simplex = grid.locate({g, g, g});
        for (std::size_t k = 0; k < 4; ++k) {
            const auto p = grid.position(simplex.node[k]);
            if (simplex.weight[k] > 0) CHECK((p[0] == p[1] && p[1] == p[2]));
        }
    }
}

TEST_CASE("the four nodes are the corners of one Kuhn tetrahedron of the point's cell") {
    const Grid grid(9);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int trial = 0; trial < 5000; ++trial) {
        const std::array<float, 3> point = {uniform(random), uniform(random), uniform(random)};
        const GridSimplex simplex = grid.locate(point);
        const auto low = grid.position(simplex.node[0]);
        const auto high = grid.position(simplex.node[3]);
        for (std::size_t i = 0; i < 3; ++i) {
            // Root, product and the node's square are each rounded, and the root counts twice.
            CHECK(low[i] <= point[i] * (1 + 5 * 0x1p-24F));
            CHECK(point[i] <= high[i]);
        }
        for (std::size_t k = 0; k + 1 < 4; ++k) {
            const auto a = grid.position(simplex.node[k]);
            const auto b = grid.position(simplex.node[k + 1]);
            const int changed = (a[0] < b[0]) + (a[1] < b[1]) + (a[2] < b[2]);
            const int same = (a[0] == b[0]) + (a[1] == b[1]) + (a[2] == b[2]);
            CHECK(changed == 1);
            CHECK(same == 2);
        }
    }
}

TEST_CASE("a resolution outside 2 to 129 is refused") {
    CHECK_THROWS_AS(Grid(1), ArgumentError);
    CHECK_THROWS_AS(Grid(130), ArgumentError);
}
