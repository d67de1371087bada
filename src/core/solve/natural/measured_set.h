#pragma once

#include <specbake/core/measured_sample.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// Reflectances that were measured together: a chart, a laboratory, a material.
struct MeasuredSet {
    std::string name;
    std::vector<MeasuredSample> samples;
};

/// Those of data/natural.csv. The sources are named there.
const std::vector<MeasuredSet>& builtInSets();

/// The built-in sets without those named.
std::vector<MeasuredSet> builtInSetsWithout(std::span<const std::string_view> names);

/// All samples of a material, of whatever set.
std::vector<MeasuredSample> samplesOfMaterial(const std::vector<MeasuredSet>& sets,
                                              std::string_view material);

/// Samples where an observer's spectra stand; what weighs nothing there repeats the last band.
std::vector<MeasuredSample> atKnots(std::vector<MeasuredSample> samples, const Wavelengths& knots);

}  // namespace specbake::internal
