#pragma once

#include <string>
#include <vector>

namespace specbake::testing {

/// A CSV file below tests/data/ or data/: rows of cells, without '#' lines and the heading.
/// Throws std::runtime_error where it is absent, so that a test cannot pass on nothing.
std::vector<std::vector<std::string>> readCsv(const std::string& pathBelowSource);

}  // namespace specbake::testing
