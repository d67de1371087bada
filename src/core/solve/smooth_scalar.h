#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

namespace specbake::internal {

/// SmoothSolver's iteration, one colour at a time: what smooth_lanes.h is tested against, and the
/// way to the few colours that Newton does not reach at once.
class ScalarSmoothSolver : public Solver {
  public:
    explicit ScalarSmoothSolver(const Observer& observer) : observer_(observer) {}

    /// As SmoothSolver::solve(), to 1e-10 in every band.
    Solution solve(const XYZ& color) const override;

    /// From the grey of the same luminance towards the colour, in steps that Newton follows.
    Solution approach(const XYZ& color) const;

  private:
    Observer observer_;
};

}  // namespace specbake::internal
