#include "solve/descent/descent_method.h"

#include "solve/descent/descent.h"
#include "solve/shell.h"

namespace specbake::internal {
namespace {

DescentOptions optionsFor(SolverUse use) {
    using Start = DescentOptions::Start;
    using Bound = DescentOptions::Bound;
    const bool single = use == SolverUse::singleColors;
    DescentOptions options;
    options.start = single ? Start::random : Start::flat;
    options.bound = single ? Bound::kept : Bound::released;
    return options;
}

class DescentOrShell : public Solver {
  public:
    DescentOrShell(const Observer& observer, const Solid& solid, const DescentOptions& options)
        : descent_(observer, options), shell_(observer, solid) {}

    Solution solve(const XYZ& color) const override {
        Solution solution = descent_.solve(color);
        if (solution.solved()) return solution;
        solution = shell_.solve(color);
        solution.report.fellBack = true;
        return solution;
    }

  private:
    DescentSolver descent_;
    ShellSolver shell_;
};

}  // namespace

std::shared_ptr<const Solver> makeDescent(const Observer& observer, const Solid& solid,
                                          SolverUse use) {
    return std::make_shared<const DescentOrShell>(observer, solid, optionsFor(use));
}

}  // namespace specbake::internal
