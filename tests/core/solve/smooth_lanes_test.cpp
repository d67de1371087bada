#include "solve/smooth_lanes.h"

#include "solve/smooth_scalar.h"
#include "support/each_target.h"
#include "support/sample_colors.h"

#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using specbake::testing::SampleColors;

namespace {

/// Of the sRGB cube, dark ones, and near the boundary.
std::vector<XYZ> colorsUnder(const Observer& observer, std::size_t count) {
    SampleColors samples(observer, 3);
    std::vector<XYZ> colors;
    while (colors.size() < count) {
        colors.push_back(samples.sRGB());
        colors.push_back(samples.sRGB(0.02));
        colors.push_back(samples.atGauge(0.9));
        colors.push_back(samples.atGauge(0.99));
    }
    return colors;
}

std::vector<Solution> solved(const Observer& observer, const std::vector<XYZ>& colors) {
    std::vector<Solution> solutions(colors.size());
    std::vector<std::size_t> places(colors.size());
    std::iota(places.begin(), places.end(), 0);
    solveInLanes(LaneModel(observer), colors, places, solutions);
    return solutions;
}

std::size_t differences(const std::vector<Solution>& a, const std::vector<Solution>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        count += std::memcmp(&a[i].spectrum, &b[i].spectrum, sizeof(Spectrum)) != 0;
    }
    return count;
}

}  // namespace

TEST_CASE("many colours at once have the spectra that each has by itself") {
    for (const char* light : {"D65", "A", "F11"}) {
        CAPTURE(light);
        const Observer observer(light);
        const ScalarSmoothSolver reference(observer);
        const std::vector<XYZ> colors = colorsUnder(observer, 1200);
        onEachTarget([&] {
            const std::vector<Solution> many = solved(observer, colors);
            std::size_t left = 0;
            double farthest = 0;
            double residual = 0;
            for (std::size_t i = 0; i < colors.size(); ++i) {
                if (!many[i].solved()) {
                    ++left;
                    continue;
                }
                const Solution one = reference.solve(colors[i]);
                REQUIRE(one.solved());
                farthest = std::max(farthest, maxDifference(one.spectrum, many[i].spectrum));
                const XYZ color = observer.color(many[i].spectrum);
                residual = std::max(
                    residual, largestComponent(color - colors[i]) / largestComponent(colors[i]));
            }
            CHECK(left <= colors.size() / 100);  // they are left to be approached in steps
            CHECK(farthest <= 1e-10);
            CHECK(residual <= 1.1e-12);  // the tolerance, and the roundings of another sum
        });
    }
}

TEST_CASE("a colour's bits depend on the colour alone") {
    const Observer observer("D50");
    const std::vector<XYZ> colors = colorsUnder(observer, 400);
    onEachTarget([&] {
        const std::vector<Solution> together = solved(observer, colors);
        std::vector<Solution> alone;
        for (const XYZ& color : colors) alone.push_back(solved(observer, {color}).front());
        CHECK(differences(together, alone) == 0);

        std::vector<std::size_t> order(colors.size());
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), std::mt19937(4));
        std::vector<XYZ> shuffled;
        for (const std::size_t i : order) shuffled.push_back(colors[i]);
        const std::vector<Solution> found = solved(observer, shuffled);
        std::vector<Solution> sorted(colors.size());
        for (std::size_t i = 0; i < order.size(); ++i) sorted[order[i]] = found[i];
        CHECK(differences(together, sorted) == 0);
    });
}

TEST_CASE("no colours, and colours that have no spectrum, end") {
    const Observer observer("E");
    CHECK(solved(observer, {}).empty());
    const auto outside = solved(observer, {XYZ(0.9, 0.1, 0.1), XYZ(0.2, 0.3, 0.2), XYZ(5, 5, 1)});
    CHECK_FALSE(outside[0].solved());
    CHECK(outside[1].solved());
    CHECK_FALSE(outside[2].solved());
}
