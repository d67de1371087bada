#pragma once

#include "solve/natural/vote.h"

#include <memory>

namespace specbake::internal {

/// s + α v, with the largest α ≤ 1 that keeps it in [0, 1]. Both are continuous in what a solver
/// makes of a colour, and so is the sum while s is within (0, 1): α is 1, or 1 over the largest of
/// v_m/(1 − s_m) and −v_m/s_m. At the solid's boundary α is 0, for there is one spectrum only.
Spectrum movedWithinBounds(const Spectrum& s, const Spectrum& v);

/// A solver, and on top of it what measured samples say that it misses (vote.h):
///
///     s(t) = s_base(t) + α v(t)                                                   (M13)
///
/// Exact, as W v = 0; bounded, by α; continuous, as the base is. White, black and greys are the
/// base's. A colour that the base does not solve is answered as the base does.
class NaturalSolver : public Solver {
  public:
    /// `base` is the observer's, and exact for what it calls solved.
    NaturalSolver(const Observer& observer, std::shared_ptr<const Solver> base,
                  const std::vector<MeasuredSet>& sets = builtInSets());

    /// Status, effort and `blended` are the base's; the residual is that of the result.
    Solution solve(const XYZ& color) const override;
    void solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const override;

    const Vote& vote() const { return vote_; }

  private:
    void move(const XYZ& color, Solution& solution) const;

    Observer observer_;
    std::shared_ptr<const Solver> base_;
    Vote vote_;
};

}  // namespace specbake::internal
