#include "solve/grey.h"

#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake::internal {
namespace {

/// The grey of a colour's luminance, if the colour is that grey to rounding.
std::optional<double> greyLevel(const XYZ& color, const XYZ& white) {
    const double level = color.y / white.y;
    const double rounding = 8 * std::numeric_limits<double>::epsilon();  // a 3x3 product's
    if (largestComponent(color - white * level) >
        rounding * std::max(largestComponent(color), 1e-300))
        return {};
    if (std::abs(level - 1) <= rounding) return 1;
    return level;
}

}  // namespace

std::optional<Solution> greySolution(const Observer& observer, const XYZ& color) {
    using enum SolveReport::Status;
    const auto level = greyLevel(color, observer.white());
    if (!level) return {};
    Solution solution{constantSpectrum(std::clamp(*level, 0.0, 1.0)), {}};
    solution.report.residual = largestComponent(observer.color(solution.spectrum) - color);
    solution.report.status = *level < 0 || *level > 1 ? outside : solved;
    return solution;
}

}  // namespace specbake::internal
