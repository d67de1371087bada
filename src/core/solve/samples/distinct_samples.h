#pragma once

#include <specbake/core/measured_sample.h>
#include <specbake/core/observer.h>

#include <string>
#include <vector>

namespace specbake::internal {

/// Places (place.h) that are no farther apart are one colour: less than is seen.
inline constexpr double kOneColor = 0.1;

/// Samples of different colours, and what was averaged for it.
struct DistinctSamples {
    std::vector<MeasuredSample> samples;
    std::vector<std::string> notes;  ///< one line, if any was averaged
};

/// Samples of one colour have their mean in the place of the first: one colour can have one
/// spectrum only. Each sample joins the first that it is near enough to.
DistinctSamples distinctSamples(const Observer& observer,
                                const std::vector<MeasuredSample>& samples);

}  // namespace specbake::internal
