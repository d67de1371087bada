#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// Spectra as a file has them: at its own wavelengths, in its own unit.
struct SampleTable {
    struct Row {
        std::string name;
        std::vector<double> values;  ///< one a wavelength
    };
    std::vector<double> wavelengths;  ///< nm
    std::vector<Row> samples;
};

/// Text to a table, in any layout of readMeasuredFile(). Throws ArgumentError, with the line where
/// there is one.
SampleTable parseSampleTable(std::string_view text);

}  // namespace specbake::internal
