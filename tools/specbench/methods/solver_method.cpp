#include "solver_method.h"

namespace specbake::bench {

Reconstruction SolverMethod::reconstruct(const XYZ& color) const {
    const Solution solution = solver_->solve(color);
    return {solution.spectrum, solution.solved()};
}

}  // namespace specbake::bench
