#pragma once

#include <specbake/core/api.h>
#include <specbake/core/outside.h>
#include <specbake/image/spectral_layout.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace specbake {

/// How a colour becomes a spectrum.
enum class Method {
    smooth,  ///< the smoothest reflectance (shell.h)
    descent  ///< the paper's descent (descent.h)
};

/// How a texture is baked. The defaults are those of `specbake bake`.
struct BakeOptions {
    std::optional<std::string> space;       ///< of colorSpaces(); none: what the file says
    std::optional<std::string> illuminant;  ///< of illuminantNames(); none: the space's own white
    Method method = Method::smooth;
    int grid = 17;          ///< nodes an axis, GridAxis::kFewestNodes to kMostNodes
    bool perTexel = false;  ///< no grid: every distinct colour is solved by itself
    Outside outside = Outside::nearest;
    int bits = 10;  ///< of the mantissa of half samples, 4 to 10
    /// Instead of `grid`: the coarsest one whose spectra deviate by at most this from the directly
    /// solved ones: RMS over the bands and the texture's own colours.
    std::optional<double> maxDeviation;
    /// Instead of `bits`: the fewest that keep every texel within this CIEDE2000.
    std::optional<double> maxDE;
    StorageOptions storage;
    int threads = 0;                       ///< 0: all cores
    std::stop_token stop;                  ///< when stopped, bake() throws Cancelled
    std::function<void(double)> progress;  ///< called with 0 to 1, from one thread at a time
};

/// What was done, for `--stats` and `-v`.
struct BakeStatistics {
    std::string space;
    std::string illuminant;
    std::size_t texels = 0;
    int grid = 0;                      ///< nodes an axis, 0 without a grid
    int bits = 0;                      ///< of the samples' mantissa
    std::optional<double> deviation;   ///< what maxDeviation met
    std::optional<double> difference;  ///< what maxDE met: the largest CIEDE2000
    std::size_t directTexels = 0;      ///< not, or not only, through the grid
    std::size_t outsideTexels = 0;     ///< whose colour no reflectance has
    double largestMove = 0;  ///< of these: CIEDE2000 from the colour asked for to that given
    std::size_t nodesSolved = 0;
    double seconds = 0;
    std::vector<std::string> notes;  ///< of the texture: what of the file was not used
};

/// The texture `input` to the spectral image `output`, which appears whole or not at all.
/// The bytes of the output depend on the input and the options but not on the threads.
/// Throws FileError, ArgumentError, Cancelled.
SPECBAKE_API BakeStatistics bake(const std::string& input, const std::filesystem::path& output,
                                 const BakeOptions& options);

}  // namespace specbake
