#pragma once

#include <specbake/core/adaptation.h>
#include <specbake/core/api.h>
#include <specbake/core/quadrature.h>
#include <specbake/image/color_meaning.h>
#include <specbake/image/texture_reader.h>

#include <cstddef>
#include <optional>
#include <string>

namespace specbake {

struct VerifyOptions {
    ColorWishes color;                      ///< none: what the spectral file says
    std::optional<std::string> illuminant;  ///< none: what the spectral file names
    std::optional<std::string> observer;    ///< none: what the spectral file names
    std::optional<Adaptation> adapt;        ///< none: what the spectral file names
    std::optional<Quadrature> quadrature;   ///< none: what the spectral file names
    int threads = 0;                        ///< 0: all cores
    ReadOptions read = {};                  ///< what is left open: as the spectral file was made
};

/// How far a spectral image is from its texture, over all texels.
///
/// "Beyond rounding" is what the rounding of the stored samples does not explain: what a bake
/// writes never is. Bands, preview and the light's name say the same thing more than once, so that
/// a preview of another picture, or the name of another light, shows there.
struct Verification {
    std::size_t texels = 0;
    double meanDE2000 = 0;  ///< CIEDE2000 beside the illuminant's white, of the texels compared
    double p99DE2000 = 0;   ///< the 99th percentile, by nearest rank
    double maxDE2000 = 0;
    double maxXYZDifference = 0;     ///< largest |ΔX|, |ΔY|, |ΔZ|
    std::size_t beyondRounding = 0;  ///< texels of which one of these is
    std::size_t notFinite = 0;       ///< texels with a number that is not finite; not compared
    std::size_t outOfRange = 0;      ///< bands outside [0, 1], NaN among them
    /// Texels whose colour no reflectance has: compared with what the file's rule gives for them.
    std::size_t outsideSolid = 0;
    std::size_t previewBeyondRounding = 0;  ///< texels; a file without R, G, B has none
    double maxPreviewDifference = 0;
    std::size_t alphaBeyondRounding = 0;  ///< texels; where one of the two has no alpha it is 1
    double maxAlphaDifference = 0;
    std::size_t worstX = 0;  ///< the texel of maxDE2000, in the data window
    std::size_t worstY = 0;
    std::string illuminant;                     ///< under which was compared
    std::string observer;                       ///< by whom
    Quadrature quadrature = Quadrature::bands;  ///< by which

    static constexpr double kUsualLimit = 0.5;

    /// Whether every number is a finite one, bands are within [0, 1], preview and alpha are right,
    /// and no texel differs by more than `maxDE` (CIEDE2000): without it, by more than rounding
    /// explains or than kUsualLimit.
    [[nodiscard]] SPECBAKE_API bool passes(std::optional<double> maxDE = {}) const;
};

/// Reads the bands back, integrates them under the file's illuminant by the file's quadrature and
/// compares with the texture. Throws FileError if a file cannot be read, names a light, observer,
/// quadrature or rule that is not known, or the two have not the same size; ArgumentError for an
/// unknown name in the options.
SPECBAKE_API Verification verify(const std::string& spectral, const std::string& texture,
                                 const VerifyOptions& options);

}  // namespace specbake
