#pragma once

#include "solve/natural/moved_solver.h"
#include "solve/samples/sample_field.h"

#include <specbake/core/measured_sample.h>
#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace specbake::internal {

/// A solver, and on top of it measured samples: what it misses at their colours, b_k (vote.h), is
/// carried on to the colours about them.
///
///     s(t) = s_base(t) + α v(p(t)),   v(p_k) = b_k                               (M18)
///
/// At a sample's colour the result is the sample; far from all samples it is the base's. Exact,
/// bounded and continuous as NaturalSolver is, by the same α.
///
/// Constrained uplifting as productions ask for it (L. Tódová, A. Wilkie, L. Fascione,
/// "Moment-based constrained spectral uplifting", EGSR 2021), with exact colours.
class SamplesSolver : public MovedSolver {
  public:
    /// `base` is the observer's; samples are of distinct colours (distinct_samples.h). A sample
    /// that the base does not solve, on the boundary of the solid, is left out.
    SamplesSolver(const Observer& observer, std::shared_ptr<const Solver> base,
                  const std::vector<MeasuredSample>& samples, const FieldShape& shape = {});

  private:
    Spectrum direction(const XYZ& color) const override;

    SampleField field_;
};

/// What a shape is worth, judged by the samples themselves, each left out in turn.
struct ShapeChoice {
    FieldShape shape;
    std::size_t samples = 0;  ///< that were left out: all, or 256 of them, evenly
    std::string light;        ///< under which reflectances were compared: A, or D65 where A is ours
    double difference = 0;    ///< mean CIEDE2000 of the sample and what the others make of it
    double without = 0;       ///< the same of the base, without samples
};

/// The shape of least `difference`, of ρ = 4, 8, 16, 32 and ω = 0, 0.1, 0.3, 1; where several are
/// as good, FieldShape's own.
ShapeChoice chooseShape(const Observer& observer, const Solver& base,
                        const std::vector<MeasuredSample>& samples);

}  // namespace specbake::internal
