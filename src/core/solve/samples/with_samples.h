#pragma once

#include "solve/natural/measured_set.h"

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>
#include <specbake/core/upsampler_options.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// A solver, and what there is to say about it.
struct NotedSolver {
    std::shared_ptr<const Solver> solver;
    std::vector<std::string> notes;
};

/// The samples of a material on top of `base`; about them it fades into the base as those of
/// SamplesSolver do, with FieldShape's own shape.
std::shared_ptr<const Solver> withMaterial(const Observer& observer,
                                           std::shared_ptr<const Solver> base,
                                           const std::vector<MeasuredSet>& sets,
                                           std::string_view material);

/// The material of the options on top of `base`, and their samples on top of that, as far as they
/// ask for them. The samples' shape is chosen by leaving each of them out; the notes say how well.
NotedSolver withSamples(const UpsamplerOptions& options, const Observer& observer,
                        std::shared_ptr<const Solver> base);

/// How many, and a hash of their reflectances.
std::string identityOf(const std::vector<MeasuredSample>& samples);

}  // namespace specbake::internal
