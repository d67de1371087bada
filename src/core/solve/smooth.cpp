#include "solve/smooth.h"

#include "solve/grey.h"

#include <vector>

namespace specbake::internal {

Solution SmoothSolver::solve(const XYZ& color) const {
    Solution solution;
    solveMany({&color, 1}, {&solution, 1});
    return solution;
}

void SmoothSolver::solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const {
    std::vector<std::size_t> chromatic;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (const auto grey = greySolution(model_.observer, colors[i])) {
            solutions[i] = *grey;
        } else {
            chromatic.push_back(i);
        }
    }
    solveInLanes(model_, colors, chromatic, solutions);
    for (const std::size_t i : chromatic) {
        if (!solutions[i].solved()) solutions[i] = scalar_.approach(colors[i]);
    }
}

}  // namespace specbake::internal
