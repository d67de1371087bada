#pragma once

#include <specbake/core/adaptation.h>
#include <specbake/core/api.h>
#include <specbake/core/quadrature.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace specbake {

/// How a spectral image is shown under a light. The defaults are those of `specbake relight`.
struct RelightOptions {
    std::string illuminant = "A";  ///< as an Observer takes it
    /// Further lights: a picture under each, side by side to the right of the first.
    std::vector<std::string> beside;
    std::optional<std::string> observer;   ///< whose eye it is (quadrature.h); none: the file's
    std::optional<Quadrature> quadrature;  ///< none: that of the file
    /// How the viewer's eye has adapted to the light: white looks white; none: it shows its tint.
    Adaptation adapt = Adaptation::bradford;
    double exposure = 0;                   ///< stops
    bool sync = false;                     ///< the picture outlives a power cut (output_file.h)
    int threads = 0;                       ///< 0: all cores
    std::stop_token stop;                  ///< when stopped, relight() throws Cancelled
    std::function<void(double)> progress;  ///< called with 0 to 1, from one thread at a time
};

/// Integrates the bands of `spectral` under the light and writes what a viewer sees, in linear
/// Rec.709 or sRGB after the format of `picture` (preview_writer.h). At exposure 0 the largest
/// component of a white surface is 1 under each light, so that no reflectance is clipped for its
/// brightness. One light keeps the windows; several are side by side in a window at (0, 0).
/// Throws FileError, ArgumentError, Cancelled.
SPECBAKE_API void relight(const std::string& spectral, const std::filesystem::path& picture,
                          const RelightOptions& options);

}  // namespace specbake
