#pragma once

#include <specbake/core/api.h>
#include <specbake/image/spectral_reader.h>

#include <cstddef>
#include <string>
#include <vector>

namespace specbake {

/// Reflectances over all texels; NaN counts as out of range and nowhere else.
struct BandStatistics {
    std::vector<double> least, mean, largest;  ///< of each band, as the reader lists them
    std::size_t texels = 0;
    std::size_t outOfRange = 0;  ///< samples outside [0, 1], NaN among them
};

/// Reads the whole file. Throws FileError.
SPECBAKE_API BandStatistics bandStatistics(const std::string& spectral);

/// The spectrum of the texel at (x, y), which counts as the file's windows do: the first texel is
/// the data window's corner. Throws FileError, and ArgumentError for a place outside the window.
SPECBAKE_API std::vector<double> spectrumAt(SpectralReader& reader, int x, int y);

}  // namespace specbake
