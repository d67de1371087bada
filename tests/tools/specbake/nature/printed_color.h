#pragma once

#include <array>
#include <string>
#include <vector>

namespace specbake::testing {

/// X, Y, Z of 81 reflectances under a light, by equation (1) and the tables of data/ as they are
/// printed.
std::array<double, 3> colorUnder(const std::string& light, const std::vector<double>& reflectance);

}  // namespace specbake::testing
