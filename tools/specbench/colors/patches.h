#pragma once

#include "commands.h"
#include "methods/csv.h"

#include <string>
#include <vector>

namespace specbake::bench {

/// A file of measured reflectances.
struct Chart {
    std::string name;
    std::vector<NamedSpectrum> patches;
};

/// All that the options name, without the few that do not conserve energy: fluorescent ones.
std::vector<Chart> readCharts(const Options& options);

}  // namespace specbake::bench
