#include <specbake/core/solver.h>

#include <algorithm>

namespace specbake {

std::string_view statusName(SolveReport::Status status) {
    switch (status) {
        case SolveReport::Status::solved:
            return "solved";
        case SolveReport::Status::outside:
            return "outside";
        case SolveReport::Status::failed:
            break;
    }
    return "failed";
}

void Solver::solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const {
    std::transform(colors.begin(), colors.end(), solutions.begin(),
                   [this](const XYZ& color) { return solve(color); });
}

}  // namespace specbake
