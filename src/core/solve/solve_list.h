#pragma once

#include <specbake/core/solver.h>

#include <cstddef>
#include <span>
#include <vector>

namespace specbake::internal {

/// Some of many colours, which are to be solved together.
struct SolveList {
    std::vector<std::size_t> places;  ///< among the many
    std::vector<XYZ> colors;
    std::vector<Solution> solutions;

    void add(std::size_t place, const XYZ& color) {
        places.push_back(place);
        colors.push_back(color);
    }
    std::size_t size() const { return places.size(); }
    bool empty() const { return places.empty(); }

    void solve(const Solver& solver) {
        solutions.resize(size());
        solver.solveMany(colors, solutions);
    }
};

}  // namespace specbake::internal
