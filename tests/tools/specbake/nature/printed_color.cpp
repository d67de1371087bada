#include "nature/printed_color.h"

#include "support/csv.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace specbake::testing {
namespace {

/// Where the heading names the light.
std::size_t columnOf(const std::string& light) {
    std::ifstream file(SPECBAKE_SOURCE_DIR "/data/illuminants_5nm.csv");
    std::string line;
    while (std::getline(file, line) && line.starts_with('#')) continue;
    std::istringstream heading(line);
    std::string name;
    for (std::size_t column = 0; std::getline(heading, name, ','); ++column) {
        if (name == light) return column;
    }
    throw std::runtime_error("no light " + light);
}

}  // namespace

std::array<double, 3> colorUnder(const std::string& light, const std::vector<double>& reflectance) {
    const auto functions = readCsv("data/cie1931_2deg_5nm.csv");
    const auto lights = readCsv("data/illuminants_5nm.csv");
    const std::size_t column = columnOf(light);
    std::array<double, 3> color{};
    double white = 0;
    for (std::size_t m = 0; m < functions.size(); ++m) {
        const double power = std::stod(lights.at(m).at(column));
        white += power * std::stod(functions[m][2]);
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] += power * std::stod(functions[m][c + 1]) * reflectance.at(m);
        }
    }
    for (double& value : color) value /= white;
    return color;
}

}  // namespace specbake::testing
