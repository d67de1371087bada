#pragma once

#include "commands.h"
#include "solve/natural/measured_set.h"

#include <string>
#include <vector>

namespace specbake::bench {

/// Measured reflectances to be rebuilt, and what may be known of others.
struct Judged {
    std::string name;
    std::vector<MeasuredSample> samples;
    std::vector<internal::MeasuredSet> voters;  ///< of `natural`
    bool counts = true;                         ///< in the mean of the sets
    /// If it is given, voters and samples of the material are all but the fold that is judged; else
    /// no voter is a sample of the set.
    std::string material = {};
    std::size_t folds = 10;
};

/// The built-in sets, each left out; skin without any skin; and the files that are named.
std::vector<Judged> judgedSets(const Options& options);

/// Each material, one sample after the other left out; and skin by that of another laboratory.
std::vector<Judged> judgedMaterials();

}  // namespace specbake::bench
