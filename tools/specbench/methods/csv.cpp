#include "csv.h"

#include <specbake/core/error.h>

#include <fstream>
#include <sstream>
#include <utility>

namespace specbake::bench {

std::vector<CsvRow> readCsv(const std::string& path) {
    std::ifstream in(path);
    if (!in) throw FileError(path, "cannot be read");
    std::vector<CsvRow> rows;
    bool heading = true;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (std::exchange(heading, false)) continue;
        CsvRow cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        rows.push_back(std::move(cells));
    }
    if (rows.empty()) throw FileError(path, "no rows");
    return rows;
}

double numberIn(const CsvRow& row, std::size_t cell, const std::string& path) try {
    return std::stod(row.at(cell));
} catch (const std::logic_error&) {  // out_of_range of at() and stod(), invalid_argument
    throw FileError(path, "a number expected in column " + std::to_string(cell + 1));
}

std::vector<NamedSpectrum> readReflectances(const std::string& path) {
    std::vector<NamedSpectrum> list;
    for (const CsvRow& row : readCsv(path)) {
        if (row.size() != kBandCount + 1) throw FileError(path, "a name and 81 values expected");
        NamedSpectrum patch{row[0], {}};
        for (std::size_t m = 0; m < patch.spectrum.size(); ++m) {
            patch.spectrum[m] = numberIn(row, m + 1, path);
        }
        list.push_back(std::move(patch));
    }
    return list;
}

}  // namespace specbake::bench
