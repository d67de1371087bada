#pragma once

#include "solve/natural/moved_solver.h"
#include "solve/natural/vote.h"

#include <memory>

namespace specbake::internal {

/// A solver, and on top of it what measured samples say that it misses (vote.h):
///
///     s(t) = s_base(t) + α v(t)                                                   (M13)
///
/// Exact, as W v = 0; bounded, by α; continuous, as the base is. White, black and greys are the
/// base's. A colour that the base does not solve is answered as the base does.
class NaturalSolver : public MovedSolver {
  public:
    /// `base` is the observer's, and exact for what it calls solved.
    NaturalSolver(const Observer& observer, std::shared_ptr<const Solver> base,
                  const std::vector<MeasuredSet>& sets = builtInSets());

    const Vote& vote() const { return vote_; }

  private:
    Spectrum direction(const XYZ& color) const override;

    Vote vote_;
};

}  // namespace specbake::internal
