#pragma once

#include <specbake/bake/bake.h>
#include <specbake/core/api.h>
#include <specbake/core/solver.h>

#include <array>
#include <optional>
#include <string>

namespace specbake {

/// One colour to solve, as a texel of a texture in that space would be.
struct ColorRequest {
    std::array<double, 3> color{};          ///< RGB of the space, or X, Y, Z
    std::string space = "lin_rec709";       ///< of colorSpaces()
    std::optional<std::string> illuminant;  ///< none: the space's own white
    Method method = Method::smooth;
    Outside outside = Outside::nearest;
};

struct ColorAnswer {
    Solution solution;  ///< status `outside` where the rule is `error`
    XYZ asked;
    XYZ given;              ///< the colour that the spectrum has
    double gauge = 0;       ///< of the colour asked for: at most 1 inside the solid
    bool outside = false;   ///< another colour than was asked for
    double difference = 0;  ///< CIEDE2000 from the colour asked for to that given
    std::string illuminant;
};

/// Throws ArgumentError for an unknown space or illuminant, or a colour that is not finite.
SPECBAKE_API ColorAnswer solveColor(const ColorRequest& request);

}  // namespace specbake
