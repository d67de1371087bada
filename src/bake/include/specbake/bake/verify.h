#pragma once

#include <specbake/core/api.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace specbake {

struct VerifyOptions {
    std::optional<std::string> space;       ///< none: what the spectral file names
    std::optional<std::string> illuminant;  ///< none: what the spectral file names
    int threads = 0;                        ///< 0: all cores
};

/// How far a spectral image is from its texture, over all texels.
struct Verification {
    std::size_t texels = 0;
    double meanDE2000 = 0;  ///< CIEDE2000 beside the illuminant's white
    double p99DE2000 = 0;   ///< not below the 99th percentile, and at most 1e-4 above it
    double maxDE2000 = 0;
    double maxXYZDifference = 0;  ///< largest |ΔX|, |ΔY|, |ΔZ|
    std::size_t outOfRange = 0;   ///< samples outside [0, 1], NaN among them
    std::size_t outsideSolid =
        0;                   ///< texels whose colour no reflectance has; they are not compared
    std::size_t worstX = 0;  ///< the texel of maxDE2000, in the data window
    std::size_t worstY = 0;
};

/// Reads the 81 bands back, integrates them under the file's illuminant and compares with the
/// texture. Throws FileError if a file cannot be read or the two have not the same size.
SPECBAKE_API Verification verify(const std::string& spectral, const std::string& texture,
                                 const VerifyOptions& options);

}  // namespace specbake
