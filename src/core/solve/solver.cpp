#include <specbake/core/solver.h>

#include <algorithm>

namespace specbake {

void Solver::solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const {
    std::transform(colors.begin(), colors.end(), solutions.begin(),
                   [this](const XYZ& color) { return solve(color); });
}

}  // namespace specbake
