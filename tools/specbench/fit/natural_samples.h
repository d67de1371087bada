#pragma once

#include "methods/csv.h"

#include <string>

namespace specbake::bench {

/// Puts the measured sets of a folder, refl_*.csv, into one file: what the method `natural` has
/// built in (data/natural.csv). Fluorescent samples, above 1, are left out. Throws FileError.
void fitNatural(const std::string& folder, const std::string& output);

/// "skin", "leaf", "wood", "ground", or "": told by the sample's name, and by that of its set.
std::string materialOf(const std::string& set, const std::string& sample);

}  // namespace specbake::bench
