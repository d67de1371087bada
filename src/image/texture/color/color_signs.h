#pragma once

#include <specbake/image/color_meaning.h>

#include <optional>
#include <string>

namespace specbake::internal {

/// Code points of ITU-T H.273, as a PNG's cICP chunk has them.
struct CodePoints {
    int primaries = 2;
    int transfer = 2;
    int matrix = 0;
    bool fullRange = true;
    bool operator==(const CodePoints&) const = default;
};

/// All that a file says about its colours, as it says it.
struct ColorSigns {
    ColorModel model = ColorModel::rgb;
    std::string icc;  ///< a profile's bytes; may be damaged
    std::optional<CodePoints> cicp;
    bool srgb = false;                        ///< a PNG's sRGB chunk
    std::optional<double> gamma;              ///< a PNG's gAMA: stored = light ^ gamma
    std::optional<Primaries> chromaticities;  ///< PNG's cHRM; EXR; TIFF
    bool operator==(const ColorSigns&) const = default;
};

}  // namespace specbake::internal
