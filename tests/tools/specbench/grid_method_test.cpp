#include "methods/grid_method.h"

#include "colors/sets.h"
#include "solve/smooth.h"

#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::bench;

TEST_CASE("through the grid: the colour is exact at any resolution, nodes are the solver's") {
    const Frame frame = sRGBFrame();
    const auto solver = std::make_shared<const SmoothSolver>(frame.observer);
    const std::vector<XYZ> colors = rgbSets(frame, 300).front().colors;
    for (const int nodes : {3, 5}) {
        GridMethod method({"smooth", ""}, frame, solver, nodes);
        method.setUp();
        CHECK(method.bytes() == std::size_t(nodes * nodes * nodes) * 384);  // 96 floats a node
        CHECK(method.name().parameters == "grid " + std::to_string(nodes));
        for (const XYZ& c : colors) {
            const Spectrum s = method.reconstruct(c).spectrum;
            const Imath::V3d d = frame.observer.color(s) - c;
            // The texel, four weights and four products of values below 1 in 24 bits, and the
            // white's largest component 1.09.
            CHECK(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) < 1.09 * 8 * 0x1p-24);
            CHECK(boundsViolation(s) < 4 * 0x1p-24);
        }
        const XYZ node = frame.xyz(RGB(0, 1, 0.25));  // on u²: node 0, last, and the middle one
        CHECK(maxDifference(method.reconstruct(node).spectrum, solver->solve(node).spectrum) <
              4 * 0x1p-24);
    }
}

TEST_CASE("through the grid: a colour outside the cube is solved directly") {
    const Frame frame = sRGBFrame();
    const auto solver = std::make_shared<const SmoothSolver>(frame.observer);
    GridMethod method({"smooth", ""}, frame, solver, 3);
    method.setUp();
    const XYZ color = frame.xyz(RGB(0.3, 0.3, -0.01));
    // The colour, and each band, rounded to a float; what the grid has beyond the solver at the
    // cube's face is added in part (M12), and has the colour 0.
    const Spectrum s = method.reconstruct(color).spectrum;
    CHECK(largestComponent(frame.observer.color(s) - color) < 1.09 * 8 * 0x1p-24);
    const XYZ far = frame.xyz(RGB(1.07, 0.6, 0.3));  // beyond 1/16 there is none of it
    // The texel rounded to 2^-24, times the steepest slope that was met (24); the band, rounded.
    CHECK(maxDifference(method.reconstruct(far).spectrum, solver->solve(far).spectrum) <
          25 * 0x1p-24);
}
