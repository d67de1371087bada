#pragma once

#include <specbake/core/api.h>

#include <cstddef>
#include <string>

namespace specbake {

/// How far two spectral images are from each other, band by band, over all texels.
struct SpectralDifference {
    std::size_t texels = 0;
    double largest = 0;         ///< |a − b| of a band, of the texels compared
    double rms = 0;             ///< over bands and texels compared
    std::size_t notFinite = 0;  ///< texels with a number that is not finite; not compared
    std::size_t worstX = 0;     ///< the texel of `largest`, in the data window
    std::size_t worstY = 0;
    double worstBand = 0;  ///< its wavelength, nm

    /// Whether every number is a finite one and no band differs by more.
    bool passes(double maxBand) const { return notFinite == 0 && largest <= maxBand; }
};

/// Reads both files whole. Throws FileError, on `spectral`, where it has another size or other
/// channels than `reference`; on either, where it cannot be read as a spectral image.
/// `threads`: 0 for all cores.
SPECBAKE_API SpectralDifference compareSpectra(const std::string& spectral,
                                               const std::string& reference, int threads = 0);

}  // namespace specbake
