#pragma once

#include <specbake/core/spectrum.h>

#include <string>
#include <vector>

namespace specbake::bench {

using CsvRow = std::vector<std::string>;

/// The rows of a CSV file, without '#' lines and the heading. Throws FileError if it cannot be read
/// or has none.
std::vector<CsvRow> readCsv(const std::string& path);

/// A row's cell as a number. Throws FileError where it is absent or not a number.
double numberIn(const CsvRow& row, std::size_t cell, const std::string& path);

struct NamedSpectrum {
    std::string name;
    Spectrum spectrum;
};

/// Measured reflectances: a name and 81 values a row. Throws FileError.
std::vector<NamedSpectrum> readReflectances(const std::string& path);

}  // namespace specbake::bench
