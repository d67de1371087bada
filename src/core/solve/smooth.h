#pragma once

#include "solve/smooth_lanes.h"
#include "solve/smooth_scalar.h"

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

namespace specbake::internal {

/// The smoothest reflectance of a colour: s = ½(1 + tanh z) with z minimising Σ (z_{m+1} - z_m)²
/// subject to W s = t (1). S. A. Burns, "Numerical methods for smoothest reflectance
/// reconstruction", Color Research & Application 45(1), 2020: least hyperbolic tangent slope
/// squared. By construction 0 < s < 1; black, white and greys come out exact (0, 1, flat).
///
/// Newton's method on the 84 stationarity equations, O(81) a step, starting from the grey of the
/// same luminance: for many colours at once, a colour in each lane of the processor's registers
/// (smooth_lanes.h). One colour goes the same way, so that its bits are the same in any company.
/// Where that does not converge the colour is approached from the grey in steps.
/// Colours at the very boundary of the object-colour solid have |z| without bound and are reported
/// as failed: see shell.h, which never fails.
class SmoothSolver : public Solver {
  public:
    explicit SmoothSolver(const Observer& observer) : model_(observer), scalar_(observer) {}

    /// `solved`: residual <= 1e-12 max(X, Y, Z), to rounding.
    Solution solve(const XYZ& color) const override;
    void solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const override;

  private:
    LaneModel model_;
    ScalarSmoothSolver scalar_;
};

}  // namespace specbake::internal
