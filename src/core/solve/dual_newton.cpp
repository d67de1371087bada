#include "solve/dual_newton.h"

#include "solve/face_modes.h"
#include "solve/polish.h"

#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace specbake::internal {
namespace {

/// Rounding errors of W s - t, a sum near 1: what is smaller is 0.
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

/// The dual function phi(mu), convex and piecewise quadratic, in terms of p = s0 + W^T mu: its
/// gradient is W clamp(p) - t.
class Dual {
  public:
    Dual(const Observer& observer, const XYZ& color) : observer_(observer), color_(color) {}

    Imath::V3d gradient(const Spectrum& p) const { return observer_.color(clamped(p)) - color_; }

    /// H, the curvature: the sum of w w^T over the components within the bounds.
    FaceModes curvature(const Spectrum& p) const {
        FreeSet free;
        free.removeIf([&](std::size_t m) { return !(p[m] > 0 && p[m] < 1); });
        return faceModes(weights(), free);
    }

    /// p at mu + step.
    Spectrum moved(Spectrum p, const Imath::V3d& step) const {
        for (std::size_t m = 0; m < p.size(); ++m) p[m] += weights()[m].dot(step);
        return p;
    }

    const Weights& weights() const { return observer_.weights(); }

    static Spectrum clamped(Spectrum p) {
        for (double& value : p) value = std::clamp(value, 0.0, 1.0);
        return p;
    }

  private:
    const Observer& observer_;
    const XYZ& color_;
};

/// A mode with a millionth of the gradient waits for the others, lest rounding be taken for it.
double negligibleSlope(const Imath::V3d& gradient) {
    return std::max(kRounding / 2, 1e-6 * gradient.length());
}

/// -H^-1 gradient, no farther than `reach` along each mode: where no free component responds, H is
/// 0 or rounding, and a longer step would drown the other modes.
Imath::V3d newtonStep(const FaceModes& curvature, const Imath::V3d& gradient, double reach) {
    Imath::V3d step(0.0);
    for (unsigned k = 0; k < 3; ++k) {
        const double slope = curvature.vectors[k].dot(gradient);
        const double rate = curvature.rates[int(k)];
        if (std::abs(slope) <= negligibleSlope(gradient)) continue;
        const double length = std::abs(slope) < reach * rate ? std::abs(slope) / rate : reach;
        step -= std::copysign(length, slope) * curvature.vectors[k];
    }
    return step;
}

/// Where a component p + a v enters or leaves (0, 1) as the step length a grows.
struct Breakpoint {
    double length;
    double curvatureChange;  ///< +v^2 or -v^2
};

/// The breakpoints ahead along a direction, in order, and phi's second derivative before the first.
std::pair<std::vector<Breakpoint>, double> breakpointsAhead(const Dual& dual, const Spectrum& p,
                                                            const Imath::V3d& direction) {
    std::vector<Breakpoint> breakpoints;
    double curvature = 0;
    for (std::size_t m = 0; m < p.size(); ++m) {
        const double v = dual.weights()[m].dot(direction);
        if (v == 0) continue;
        const double enter = (v > 0 ? -p[m] : 1 - p[m]) / v;
        const double leave = (v > 0 ? 1 - p[m] : -p[m]) / v;
        if (leave <= 0) continue;
        if (enter <= 0) curvature += v * v;
        if (enter > 0) breakpoints.push_back({enter, v * v});
        breakpoints.push_back({leave, -v * v});
    }
    std::sort(breakpoints.begin(), breakpoints.end(),
              [](const Breakpoint& a, const Breakpoint& b) { return a.length < b.length; });
    return {breakpoints, curvature};
}

/// The minimum of phi along a direction of descent. Its derivative there is piecewise linear and
/// does not decrease: walk its breakpoints until it is 0, or a billionth of what it was, since on
/// the solid's boundary it reaches 0 at infinity and rounding would lead there.
double lineMinimum(const Dual& dual, const Spectrum& p, const Imath::V3d& direction,
                   double derivative) {
    const double nearlyZero = 1e-9 * derivative;
    auto [breakpoints, curvature] = breakpointsAhead(dual, p, direction);
    double length = 0;
    for (const Breakpoint& next : breakpoints) {
        const double reached = derivative + curvature * (next.length - length);
        if (reached >= 0) return length - derivative / curvature;
        derivative = reached;
        length = next.length;
        if (derivative > nearlyZero) break;
        curvature = std::max(curvature + next.curvatureChange, 0.0);
    }
    return length;
}

/// A point of the iteration: mu, and p = s0 + W^T mu. p is carried along, not computed from mu:
/// near the boundary mu is large, and a step too small to change mu still has to change p.
struct Iterate {
    Imath::V3d mu;
    Spectrum p;

    void move(const Dual& dual, const Imath::V3d& step) {
        mu += step;
        p = dual.moved(p, step);
    }
};

/// True where the full step leaves at most a tenth of the slope along it, as it does near the
/// solution; the step is then taken.
bool takeFullStep(const Dual& dual, Iterate& at, const Imath::V3d& gradient,
                  const Imath::V3d& step) {
    const Spectrum p = dual.moved(at.p, step);
    if (!(std::abs(dual.gradient(p).dot(step)) <= 0.1 * std::abs(gradient.dot(step)))) return false;
    at.mu += step;
    at.p = p;
    return true;
}

}  // namespace

NearestReflectance nearestReflectance(const Observer& observer, const XYZ& color,
                                      const Spectrum& start, int maxIterations) {
    const Dual dual(observer, color);
    Iterate at{Imath::V3d(0.0), start};
    int iterations = 0;
    for (; iterations < maxIterations; ++iterations) {
        const Imath::V3d gradient = dual.gradient(at.p);
        if (largestComponent(gradient) <= kRounding) break;
        const FaceModes curvature = dual.curvature(at.p);
        const double reach = 10 * (at.mu.length() + 1 / observer.white().length());
        const Imath::V3d step = newtonStep(curvature, gradient, reach);
        if (takeFullStep(dual, at, gradient, step)) continue;
        at.move(dual, lineMinimum(dual, at.p, step, gradient.dot(step)) * step);
    }
    Spectrum spectrum = Dual::clamped(at.p);
    const double residual = polish(observer, color, spectrum);
    return {spectrum, at.mu, residual, iterations};
}

DualNewtonSolver::DualNewtonSolver(const Observer& observer, const DualNewtonOptions& options)
    : observer_(observer), options_(options) {}

Solution DualNewtonSolver::solve(const XYZ& color) const {
    return solveFrom(color, constantSpectrum(std::clamp(color.y, 0.0, 1.0)));
}

Solution DualNewtonSolver::solveFrom(const XYZ& color, const Spectrum& start) const {
    Solution solution;
    solution.report.residual = std::numeric_limits<double>::infinity();
    if (!(largestComponent(color) <= std::numeric_limits<double>::max())) return solution;
    const NearestReflectance nearest =
        nearestReflectance(observer_, color, start, options_.maxIterations);
    solution.spectrum = nearest.spectrum;
    solution.report.residual = nearest.residual;
    solution.report.iterations = nearest.iterations;
    if (nearest.residual <= options_.tolerance) {
        solution.report.status = SolveReport::Status::solved;
    }
    return solution;
}

}  // namespace specbake::internal
