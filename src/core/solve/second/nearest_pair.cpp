#include "solve/second/nearest_pair.h"

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

constexpr double kFirstProduct = 1e-4;  ///< of a slack and its multiplier, at the start
constexpr double kLastProduct = 1e-20;  ///< the square of the distance is within 324 times this
constexpr double kShrink = 0.1;         ///< of the product, aimed at by a step
constexpr double kCautious = 0.5;       ///< the same after a step that a bound cut short
constexpr double kMostOfWay = 0.99;     ///< of the way to the nearest bound, at most
constexpr int kMostSteps = 200;

/// A reflectance, and the multipliers of its bounds.
struct Point {
    Spectrum s{};
    Spectrum lower{};  ///< of s >= 0
    Spectrum upper{};  ///< of s <= 1

    double product() const {
        double sum = 0;
        for (std::size_t m = 0; m < s.size(); ++m) sum += s[m] * lower[m] + (1 - s[m]) * upper[m];
        return sum / (2.0 * kBandCount);
    }
};

Point startFrom(const Spectrum& s) {
    constexpr double least = 1e-9;
    Point p;
    for (std::size_t m = 0; m < s.size(); ++m) {
        p.s[m] = std::clamp(s[m], least, 1 - least);
        p.lower[m] = kFirstProduct / p.s[m];
        p.upper[m] = kFirstProduct / (1 - p.s[m]);
    }
    return p;
}

/// The largest part of a step, at most 1, that keeps value + part·change above a hundredth of
/// value.
double partOf(double value, double change, double part) {
    return change < 0 ? std::min(part, -kMostOfWay * value / change) : part;
}

/// A vector of the bands, and of what is left of the second colour's three equations.
using Long = std::array<double, kBandCount + 3>;

double dot(const Long& a, const Long& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

void addMultiple(Long& to, double factor, const Long& v) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * v[i];
}

/// The x nearest to the given one with row_e · x = right_e: each equation is met by a move across
/// those before it (Gram & Schmidt), which loses less than the matrix of products of rows does.
void meet(std::array<Long, kSix> rows, const Six& right, Long& x) {
    for (std::size_t e = 0; e < kSix; ++e) {
        const Long row = rows[e];
        for (int again = 0; again < 2; ++again) {
            for (std::size_t f = 0; f < e; ++f)
                addMultiple(rows[e], -dot(rows[e], rows[f]), rows[f]);
        }
        const double length = std::sqrt(dot(rows[e], rows[e]));
        if (!(length > 0)) continue;
        for (double& value : rows[e]) value /= length;
        addMultiple(x, (right[e] - dot(row, x)) / dot(row, rows[e]), rows[e]);
    }
}

/// The step towards products of `aim`. Eliminating the multipliers of the bounds leaves
///
///     min ½ Σ D_m (d_m − p_m/D_m)² + ½ |v|²   subject to   W₁ d = −r₁,   W₂ d + v = −r₂,
///     D = lower/s + upper/(1−s),   p = aim/s − aim/(1−s)
///
/// the point of six equations that is nearest to another, in the coordinates √D d.
Point stepOf(const Point& p, const SixWeights& weights, const Six& miss, double aim) {
    std::array<Long, kSix> rows{};
    Long x{};
    Spectrum scale;  // 1/√D
    for (std::size_t m = 0; m < p.s.size(); ++m) {
        const double s = p.s[m], rest = 1 - s;
        scale[m] = 1 / std::sqrt(p.lower[m] / s + p.upper[m] / rest);
        x[m] = scale[m] * (aim / s - aim / rest);
        for (std::size_t e = 0; e < kSix; ++e) rows[e][m] = scale[m] * weights[m][e];
    }
    for (std::size_t c = 0; c < 3; ++c) rows[3 + c][kBandCount + c] = 1;
    meet(rows, Six{} - miss, x);
    Point step;
    for (std::size_t m = 0; m < p.s.size(); ++m) {
        const double s = p.s[m], rest = 1 - s, d = scale[m] * x[m];
        step.s[m] = d;
        step.lower[m] = aim / s - p.lower[m] - p.lower[m] / s * d;
        step.upper[m] = aim / rest - p.upper[m] + p.upper[m] / rest * d;
    }
    return step;
}

/// As far as bounds let; the part of the step that was gone.
double go(Point& p, const Point& step) {
    double part = 1;
    for (std::size_t m = 0; m < p.s.size(); ++m) {
        part = partOf(p.s[m], step.s[m], part);
        part = partOf(1 - p.s[m], -step.s[m], part);
        part = partOf(p.lower[m], step.lower[m], part);
        part = partOf(p.upper[m], step.upper[m], part);
    }
    for (std::size_t m = 0; m < p.s.size(); ++m) {
        p.s[m] += part * step.s[m];
        p.lower[m] += part * step.lower[m];
        p.upper[m] += part * step.upper[m];
    }
    return part;
}

double missOfFirst(const Six& miss) {
    return largestOf({miss[0], miss[1], miss[2]});
}

}  // namespace

std::optional<Spectrum> nearestPair(const SixWeights& weights, const Spectrum& start,
                                    const Six& target) {
    constexpr double exact = 1e-12;
    std::optional<Spectrum> best;
    Point p = startFrom(start);
    double part = 1;
    for (int i = 0; i < kMostSteps; ++i) {
        const Six miss = colorsOf(weights, p.s) - target;
        if (missOfFirst(miss) <= exact) best = p.s;
        const double product = p.product();
        if (product <= kLastProduct) break;
        const Point step = stepOf(p, weights, miss, (part < 0.5 ? kCautious : kShrink) * product);
        if (!std::isfinite(step.product())) break;
        part = go(p, step);
    }
    return best;
}

}  // namespace specbake::internal
