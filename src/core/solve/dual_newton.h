#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

namespace specbake::internal {

/// The point of the box nearest to a start, of those that have the colour:
///
///     min |s - s0|^2 / 2   subject to  W s = t,  0 <= s <= 1.
///
/// Its optimality conditions are s = clamp(s0 + W^T mu) and W s = t: three unknowns, the zero of
/// the gradient of a convex, piecewise quadratic function. It exists and is unique for every
/// colour of the solid, the boundary included.
struct NearestReflectance {
    Spectrum spectrum;
    Imath::V3d multiplier;  ///< mu; grows without limit towards the boundary
    double residual = 0;    ///< max |W s - t|
    int iterations = 0;     ///< Newton steps
};

/// Semismooth Newton with an exact line search. `start` is any spectrum, `color` finite. Ends at
/// rounding, or after `maxIterations` steps.
NearestReflectance nearestReflectance(const Observer& observer, const XYZ& color,
                                      const Spectrum& start, int maxIterations = 100);

struct DualNewtonOptions {
    int maxIterations = 100;
    double tolerance = 1e-12;  ///< of max |W s - t|, for the status `solved`
};

/// The reflectance nearest to the constant Y. The cross-check of the other solvers: it does not
/// fail for a colour of the solid. It is continuous in the colour, though rarely smooth in
/// wavelength. Colours outside, and those that are not finite, have status `failed`.
class DualNewtonSolver : public Solver {
  public:
    explicit DualNewtonSolver(const Observer& observer, const DualNewtonOptions& options = {});

    Solution solve(const XYZ& color) const override;
    /// The reflectance nearest to `start`.
    Solution solveFrom(const XYZ& color, const Spectrum& start) const;

  private:
    Observer observer_;
    DualNewtonOptions options_;
};

}  // namespace specbake::internal
