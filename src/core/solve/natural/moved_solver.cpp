#include "solve/natural/moved_solver.h"

#include <specbake/core/vector.h>

#include <algorithm>
#include <utility>

namespace specbake::internal {

Spectrum movedWithinBounds(const Spectrum& s, const Spectrum& v) {
    double excess = 1;  // 1/α
    for (std::size_t m = 0; m < s.size(); ++m) {
        if (v[m] > 0) excess = std::max(excess, v[m] / (1 - s[m]));
        if (v[m] < 0) excess = std::max(excess, -v[m] / s[m]);
    }
    Spectrum moved;
    for (std::size_t m = 0; m < s.size(); ++m) {
        moved[m] = std::clamp(s[m] + v[m] / excess, 0.0, 1.0);  // what rounding adds
    }
    return moved;
}

MovedSolver::MovedSolver(const Observer& observer, std::shared_ptr<const Solver> base)
    : observer_(observer), base_(std::move(base)) {}

Solution MovedSolver::solve(const XYZ& color) const {
    Solution solution = base_->solve(color);
    move(color, solution);
    return solution;
}

void MovedSolver::solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const {
    base_->solveMany(colors, solutions);
    for (std::size_t i = 0; i < colors.size(); ++i) move(colors[i], solutions[i]);
}

void MovedSolver::move(const XYZ& color, Solution& solution) const {
    if (!solution.solved()) return;
    solution.spectrum = movedWithinBounds(solution.spectrum, direction(color));
    solution.report.residual = largestComponent(observer_.color(solution.spectrum) - color);
}

}  // namespace specbake::internal
