#include "solve/smooth_scalar.h"

#include "solve/bordered_tridiagonal.h"
#include "solve/grey.h"
#include "solve/newton_limits.h"

#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

using Imath::V3d;

/// z and the three multipliers, with the two residuals of the stationarity equations.
struct Point {
    std::array<double, kBandCount> z;
    V3d multipliers{0.0};
};

/// s = ½(1 + tanh z), its complement and ds/dz = 2 s (1 - s), none with cancellation.
struct Reflectance {
    double value;
    double complement;
    double slope;
};

Reflectance reflectanceOf(double z) {
    const double e = std::exp(-2 * std::min(std::abs(z), kHeldAt));
    const double larger = 1 / (1 + e);
    const double smaller = e * larger;
    const double slope = 2 * larger * smaller;
    return z < 0 ? Reflectance{smaller, larger, slope} : Reflectance{larger, smaller, slope};
}

/// The Lagrangian's first and second derivatives at a point.
struct Linearisation {
    Spectrum s;
    BorderedTridiagonal hessian;
    BorderedVector gradient;

    double slope() const {
        double worst = 0;
        for (const double g : gradient.x) worst = std::max(worst, std::abs(g));
        return worst;
    }
    double residual() const { return largestComponent(gradient.y); }
};

/// L = ½ Σ (z_{m+1} - z_m)² + λ·(W s(z) - t)
Linearisation linearise(const Observer& observer, const XYZ& target, const Point& p) {
    const auto& w = observer.weights();
    constexpr std::size_t last = kBandCount - 1;
    Linearisation l;
    l.gradient.y = -target;
    for (std::size_t m = 0; m <= last; ++m) {
        const auto [s, complement, ds] = reflectanceOf(p.z[m]);
        const double pull = w[m].dot(p.multipliers);
        const double toLower = m > 0 ? p.z[m] - p.z[m - 1] : 0;
        const double toUpper = m < last ? p.z[m] - p.z[m + 1] : 0;
        l.s[m] = s;
        l.gradient.x[m] = toLower + toUpper + ds * pull;
        l.gradient.y += w[m] * s;
        l.hessian.diagonal[m] = (m > 0) + (m < last) + 2 * ds * (complement - s) * pull;
        l.hessian.border[m] = w[m] * ds;
    }
    return l;
}

/// One damped Newton step; false where there is none.
bool step(const Linearisation& l, Point& p) {
    BorderedVector change = l.gradient;
    if (!solveInPlace(l.hessian, change)) return false;
    double longest = 0;
    for (const double dz : change.x) longest = std::max(longest, std::abs(dz));
    if (!std::isfinite(longest)) return false;
    const double damping = std::min(1.0, kLongestStep / longest);
    for (std::size_t m = 0; m < p.z.size(); ++m) p.z[m] -= damping * change.x[m];
    p.multipliers -= change.y * damping;
    return true;
}

struct Outcome {
    bool converged = false;
    int iterations = 0;
    Linearisation last;
};

Outcome newton(const Observer& observer, const XYZ& target, Point& p) {
    Outcome outcome;
    for (;; ++outcome.iterations) {
        outcome.last = linearise(observer, target, p);
        outcome.converged = outcome.last.residual() <= kTolerance * largestComponent(target) &&
                            outcome.last.slope() <= kSlopeTolerance;
        if (outcome.converged || outcome.iterations == kMaxIterations) return outcome;
        if (!step(outcome.last, p)) return outcome;
    }
}

Solution solutionOf(const Outcome& outcome) {
    using enum SolveReport::Status;
    Solution solution{outcome.last.s, {}};
    solution.report.status = outcome.converged ? solved : failed;
    solution.report.residual = outcome.last.residual();
    solution.report.iterations = outcome.iterations;
    return solution;
}

/// From the grey towards the colour, halving the stride where Newton does not follow.
Outcome approachFrom(const Observer& observer, const XYZ& grey, const XYZ& color, Point p) {
    Outcome outcome;
    int iterations = 0;
    double reached = 0;
    for (double stride = 0.5; stride > 1.0 / 256 && reached < 1; iterations += outcome.iterations) {
        const double next = std::min(1.0, reached + stride);
        Point trial = p;
        outcome = newton(observer, XYZ(grey + (color - grey) * next), trial);
        if (outcome.converged) {
            p = trial;
            reached = next;
        } else {
            stride /= 2;
        }
    }
    if (reached < 1) outcome = newton(observer, color, p);
    outcome.iterations += iterations;
    return outcome;
}

double luminanceOf(const XYZ& color) {
    return std::clamp(color.y, kLeastLuminance, 1 - kLeastLuminance);
}

/// The grey of the colour's luminance.
Point startFor(const XYZ& color) {
    const double luminance = luminanceOf(color);
    Point start;
    start.z.fill(0.5 * std::log(luminance / (1 - luminance)));
    return start;
}

}  // namespace

Solution ScalarSmoothSolver::solve(const XYZ& color) const {
    if (const auto grey = greySolution(observer_, color)) return *grey;
    Point p = startFor(color);
    const Outcome outcome = newton(observer_, color, p);
    return outcome.converged ? solutionOf(outcome) : approach(color);
}

Solution ScalarSmoothSolver::approach(const XYZ& color) const {
    const XYZ grey(observer_.white() * luminanceOf(color));
    return solutionOf(approachFrom(observer_, grey, color, startFor(color)));
}

}  // namespace specbake::internal
