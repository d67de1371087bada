#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

#include <memory>
#include <span>

namespace specbake::internal {

/// s + α v, with the largest α ≤ 1 that keeps it in [0, 1]. Both are continuous in what a solver
/// makes of a colour, and so is the sum while s is within (0, 1): α is 1, or 1 over the largest of
/// v_m/(1 − s_m) and −v_m/s_m. At the solid's boundary α is 0, for there is one spectrum only.
Spectrum movedWithinBounds(const Spectrum& s, const Spectrum& v);

/// A solver on top of another: s(t) = s_base(t) + α v(t), where W v = 0. Exact, bounded by α, and
/// continuous where base and v are. A colour that the base does not solve is answered as the base
/// does.
class MovedSolver : public Solver {
  public:
    /// Status, effort and `blended` are the base's; the residual is that of the result.
    Solution solve(const XYZ& color) const final;
    void solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const final;

  protected:
    /// `base` is the observer's, and exact for what it calls solved.
    MovedSolver(const Observer& observer, std::shared_ptr<const Solver> base);

    const Observer& observer() const { return observer_; }
    const Solver& base() const { return *base_; }

  private:
    /// v(t)
    virtual Spectrum direction(const XYZ& color) const = 0;
    void move(const XYZ& color, Solution& solution) const;

    Observer observer_;
    std::shared_ptr<const Solver> base_;
};

}  // namespace specbake::internal
