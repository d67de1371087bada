#include "solve/shell.h"

#include <specbake/core/error.h>
#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace specbake::internal {
namespace {

using enum SolveReport::Status;

bool isFinite(const XYZ& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

/// Black, or white as an RGB matrix rounds it: they keep their spectra exactly.
std::optional<double> cornerValue(const XYZ& color, const XYZ& white) {
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    if (color == XYZ(0, 0, 0)) return 0;
    if (largestComponent(color - white) <= rounding * largestComponent(white)) return 1;
    return {};
}

Solution report(const Observer& observer, const XYZ& color, const Spectrum& spectrum,
                SolveReport::Status status) {
    Solution solution{spectrum, {}};
    solution.report.status = status;
    solution.report.residual = largestComponent(observer.color(spectrum) - color);
    return solution;
}

}  // namespace

ShellSolver::ShellSolver(const Observer& observer, const Solid& solid, double relativeDepth)
    : relativeDepth_(relativeDepth), observer_(observer), solid_(solid), smooth_(observer) {
    if (!(relativeDepth > 0 && relativeDepth <= 1)) {
        throw ArgumentError("the shell's relative depth must be above 0 and at most 1");
    }
}

double ShellSolver::depth(const XYZ& boundary) const {
    const XYZ& white = solid_.white();
    const double m = (boundary.x + boundary.y + boundary.z) / (white.x + white.y + white.z);
    return std::max(0.0, relativeDepth_ * 4 * m * (1 - m));
}

Solution ShellSolver::solve(const XYZ& color) const {
    if (!isFinite(color)) return {};
    if (const auto value = cornerValue(color, solid_.white())) {
        return report(observer_, color, constantSpectrum(*value), solved);
    }
    const double r = solid_.gauge(color);
    if (r > 1 + 4 * solid_.gaugeError()) {
        return report(observer_, color, solid_.boundary(color).spectrum, outside);
    }
    const Imath::V3d toBoundary = (color - solid_.center()) / std::max(r, 1e-300);
    if (1 - r >= depth(XYZ(solid_.center() + toBoundary))) {
        const Solution solution = smooth_.solve(color);
        if (solution.solved()) return solution;
    }
    return blend(color);
}

/// In the layer; also the way out if Newton should fail below it.
Solution ShellSolver::blend(const XYZ& color) const {
    const Solid::Boundary boundary = solid_.boundary(color);
    const double below = 1 - boundary.gauge;  // d
    if (below <= 0) return report(observer_, color, boundary.spectrum, solved);
    const double layer = depth(boundary.color);
    double deep = below < layer ? layer : std::min(1.0, 2 * below);  // D
    SolveReport effort;
    for (effort.starts = 1;; ++effort.starts, deep = std::min(1.0, 2 * deep)) {
        const Imath::V3d fromCenter = (boundary.color - solid_.center()) * (1 - deep);
        const Solution inner = smooth_.solve(XYZ(solid_.center() + fromCenter));
        effort.iterations += inner.report.iterations;
        if (!inner.solved() && deep < 1) continue;
        Solution solution =
            report(observer_, color, mix(boundary.spectrum, inner.spectrum, below / deep), solved);
        solution.report.iterations = effort.iterations;
        solution.report.starts = effort.starts;
        solution.report.blended = true;
        return solution;
    }
}

}  // namespace specbake::internal
