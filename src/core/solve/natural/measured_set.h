#pragma once

#include <specbake/core/spectrum.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// A measured reflectance, in [0, 1].
struct MeasuredSample {
    std::string name;
    std::string material;  ///< "skin", "leaf", "wood", "ground", or "" if it is none of these
    Spectrum reflectance{};
};

/// Reflectances that were measured together: a chart, a laboratory, a material.
struct MeasuredSet {
    std::string name;
    std::vector<MeasuredSample> samples;
};

/// Those of data/natural.csv. The sources are named there.
const std::vector<MeasuredSet>& builtInSets();

/// The built-in sets without those named.
std::vector<MeasuredSet> builtInSetsWithout(std::span<const std::string_view> names);

}  // namespace specbake::internal
