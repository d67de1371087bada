#include "solve/shell.h"

#include "solve/solve_list.h"

#include <specbake/core/error.h>
#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

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
    Solution solution;
    solveMany({&color, 1}, {&solution, 1});
    return solution;
}

void ShellSolver::solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const {
    SolveList deep;
    std::vector<std::size_t> layer;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const XYZ& color = colors[i];
        solutions[i] = {};
        if (!isFinite(color)) continue;
        if (const auto value = cornerValue(color, solid_.white())) {
            solutions[i] = report(observer_, color, constantSpectrum(*value), solved);
            continue;
        }
        const double r = solid_.gauge(color);
        const Imath::V3d toBoundary = (color - solid_.center()) / std::max(r, 1e-300);
        if (r > 1 + 4 * solid_.gaugeError()) {
            solutions[i] = report(observer_, color, solid_.boundary(color).spectrum, outside);
        } else if (1 - r >= depth(XYZ(solid_.center() + toBoundary))) {
            deep.add(i, color);
        } else {
            layer.push_back(i);
        }
    }
    deep.solve(smooth_);
    for (std::size_t k = 0; k < deep.size(); ++k) {
        solutions[deep.places[k]] = deep.solutions[k];
        if (!deep.solutions[k].solved()) layer.push_back(deep.places[k]);
    }
    blend(colors, layer, solutions);
}

/// A colour of the layer, on the way to its mixture.
struct ShellSolver::Layered {
    Solid::Boundary boundary;
    std::size_t place = 0;
    double below = 0;  ///< d
    double deep = 0;   ///< D
    int starts = 1;
    int iterations = 0;
};

/// In the layer; also the way out if Newton should fail below it.
void ShellSolver::blend(std::span<const XYZ> colors, std::span<const std::size_t> places,
                        std::span<Solution> solutions) const {
    std::vector<Layered> waiting;
    for (const std::size_t i : places) {
        Layered colour{solid_.boundary(colors[i]), i};
        colour.below = 1 - colour.boundary.gauge;
        const double layer = depth(colour.boundary.color);
        colour.deep = colour.below < layer ? layer : std::min(1.0, 2 * colour.below);
        if (colour.below > 0) {
            waiting.push_back(colour);
        } else {
            solutions[i] = report(observer_, colors[i], colour.boundary.spectrum, solved);
        }
    }
    while (!waiting.empty()) {
        SolveList inner;
        for (const Layered& c : waiting) {
            const Imath::V3d fromCenter = (c.boundary.color - solid_.center()) * (1 - c.deep);
            inner.add(c.place, XYZ(solid_.center() + fromCenter));
        }
        inner.solve(smooth_);
        std::vector<Layered> failed;
        for (std::size_t k = 0; k < waiting.size(); ++k) {
            Layered& c = waiting[k];
            c.iterations += inner.solutions[k].report.iterations;
            if (!inner.solutions[k].solved() && c.deep < 1) {
                c.deep = std::min(1.0, 2 * c.deep);
                ++c.starts;
                failed.push_back(c);
            } else {
                solutions[c.place] = mixture(colors[c.place], c, inner.solutions[k].spectrum);
            }
        }
        waiting = std::move(failed);
    }
}

Solution ShellSolver::mixture(const XYZ& color, const Layered& c, const Spectrum& inner) const {
    const Spectrum mixed = mix(c.boundary.spectrum, inner, c.below / c.deep);
    Solution solution = report(observer_, color, mixed, solved);
    solution.report.iterations = c.iterations;
    solution.report.starts = c.starts;
    solution.report.blended = true;
    return solution;
}

}  // namespace specbake::internal
