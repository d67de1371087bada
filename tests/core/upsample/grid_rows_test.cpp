#include "support/each_target.h"
#include "upsample/grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace specbake;
using namespace specbake::internal;

namespace {

using Point = std::array<float, 3>;

/// Random points; nodes and their neighbours, where the cell is decided by the last bit; greys,
/// whose order of axes is a tie.
std::vector<Point> points(const Grid& grid, std::mt19937& random) {
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Point> all = {{0, 0, 0}, {1, 1, 1}, {-0.0F, 0.5F, 0}, {0, 1, -0.0F}};
    for (int i = 0; i < 500; ++i) {
        all.push_back({uniform(random), uniform(random), uniform(random)});
        const float grey = uniform(random);
        all.push_back({grey, grey, grey});
        Point node = grid.position(std::uint32_t(random() % grid.nodeCount()));
        all.push_back(node);
        for (float& v : node) v = std::nextafter(v, random() % 2 == 0 ? 0.0F : 1.0F);
        all.push_back(node);
    }
    return all;
}

}  // namespace

TEST_CASE("points found together are where they are found one by one") {
    onEachTarget([] {
        std::mt19937 random(9);
        for (const int nodes : {2, 3, 17, 33, 129}) {
            const Grid grid(nodes);
            const auto all = points(grid, random);
            int differences = 0;
            for (std::size_t first = 0, count = 0; first + count <= all.size(); first += count++) {
                std::vector<std::array<std::uint32_t, 4>> found(count);
                std::vector<std::array<float, 4>> weights(count);
                grid.locate(std::span(all).subspan(first, count), found, weights);
                for (std::size_t i = 0; i < count; ++i) {
                    const GridSimplex expected = grid.locate(all[first + i]);
                    differences += expected.node != found[i] || expected.weight != weights[i];
                }
            }
            CHECK(differences == 0);
        }
    });
}

TEST_CASE("what is no point of the cube still gets nodes of the grid") {
    onEachTarget([] {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        constexpr float none = std::numeric_limits<float>::quiet_NaN();
        const Grid grid(17);
        std::mt19937 random(4);
        const std::array<float, 8> hostile = {none, infinity, -infinity, -1, 2, 1e38F, -1e-38F, 1};
        std::vector<Point> all(1000);
        for (Point& p : all) {
            for (float& v : p) v = hostile[random() % hostile.size()];
        }
        std::vector<std::array<std::uint32_t, 4>> found(all.size());
        std::vector<std::array<float, 4>> weights(all.size());
        grid.locate(all, found, weights);
        for (const auto& nodes : found) {
            for (const std::uint32_t node : nodes) REQUIRE(node < grid.nodeCount());
        }
    });
}
