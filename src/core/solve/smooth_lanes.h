#pragma once

#include "solve/first_step.h"

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

#include <cstddef>
#include <span>

namespace specbake::internal {

/// What all colours share.
struct LaneModel {
    explicit LaneModel(const Observer& itsObserver) : observer(itsObserver), firstStep(observer) {}

    Observer observer;
    FirstStep firstStep;
};

/// The Newton iteration of (M6) for many colours at once, a colour in each lane of the processor's
/// registers; a lane that is done takes the next colour.
///
/// What a colour's spectrum is depends on the colour alone: not on its place, on the others, or on
/// how many lanes there are, as long as products and sums can be fused (AVX2, AVX-512, NEON); else
/// roundings differ. Spectra agree with ScalarSmoothSolver's to 1e-10 in every band, and meet its
/// tolerances; the exponential is Highway's, of 1 ulp.
///
/// `places`: which of the colours are to be solved; none of these is a grey. `solutions[i]` is
/// written where Newton converges from the grey of the same luminance, and its status is `solved`;
/// else the status is `failed`, and ScalarSmoothSolver::approach() may yet solve it.
void solveInLanes(const LaneModel& model, std::span<const XYZ> colors,
                  std::span<const std::size_t> places, std::span<Solution> solutions);

}  // namespace specbake::internal
