#pragma once

#include <string>
#include <vector>

namespace specbake::tool {

struct Curve {
    std::string name;
    std::vector<double> spectrum;
};

/// An SVG of reflectance over wavelength, with a legend; readable on light and on dark pages.
/// The reflectance axis goes from 0 to 1, or as far as the curves do. `wavelengths`: nm, ascending,
/// of every curve's values.
std::string spectrumPlot(const std::string& title, const std::vector<double>& wavelengths,
                         const std::vector<Curve>& curves);

}  // namespace specbake::tool
