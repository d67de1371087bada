#include "csv.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace specbake::testing {

std::vector<std::vector<std::string>> readCsv(const std::string& pathBelowSource) {
    std::ifstream in(std::string(SPECBAKE_SOURCE_DIR) + "/" + pathBelowSource);
    if (!in) throw std::runtime_error(pathBelowSource + ": cannot be read");
    std::vector<std::vector<std::string>> rows;
    bool heading = true;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (std::exchange(heading, false)) continue;
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        rows.push_back(cells);
    }
    if (rows.empty()) throw std::runtime_error(pathBelowSource + ": no rows");
    return rows;
}

}  // namespace specbake::testing
