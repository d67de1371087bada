#include "solvers.h"

namespace specbake {

std::string_view methodName(Method method) {
    return method == Method::smooth ? "smooth" : "descent";
}

MethodSolver::MethodSolver(Method method, bool perTexel, const Observer& observer)
    : shell_(observer) {
    if (method == Method::smooth) return;
    using Start = DescentOptions::Start;
    using Bound = DescentOptions::Bound;
    DescentOptions options;
    options.start = perTexel ? Start::random : Start::flat;
    options.bound = perTexel ? Bound::kept : Bound::released;
    descent_.emplace(observer, options);
}

Solution MethodSolver::solve(const XYZ& color) const {
    if (!descent_) return shell_.solve(color);
    Solution solution = descent_->solve(color);
    if (solution.solved()) return solution;
    solution = shell_.solve(color);
    solution.report.fellBack = true;
    return solution;
}

}  // namespace specbake
