#include "solve/second/nearest_pair.h"
#include "solve/second/six.h"

#include <specbake/core/second_lamp.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace specbake {

using namespace internal;

namespace {

constexpr double kStiffness = 1e-3;  ///< ε: changes of z reach over about 1/√ε bands
constexpr double kTolerance = 1e-12;
constexpr int kMostSteps = 25;

/// Six spectra, band by band.
using SixSpectra = std::array<Six, kBandCount>;

/// 1 over the pivots of K + ε I, which is tridiagonal and positive definite.
Spectrum inversePivots() {
    Spectrum inverse;
    for (std::size_t m = 0; m < inverse.size(); ++m) {
        const bool atEnd = m == 0 || m + 1 == inverse.size();
        inverse[m] = 1 / ((atEnd ? 1 : 2) + kStiffness - (m > 0 ? inverse[m - 1] : 0));
    }
    return inverse;
}

/// M x = (K + ε I)⁻¹ x, of six at once, by elimination.
void smooth(SixSpectra& x) {
    static const Spectrum inverse = inversePivots();
    for (std::size_t m = 1; m < x.size(); ++m) {
        for (std::size_t e = 0; e < kSix; ++e) x[m][e] += x[m - 1][e] * inverse[m - 1];
    }
    for (double& value : x.back()) value *= inverse.back();
    for (std::size_t m = x.size() - 1; m-- > 0;) {
        for (std::size_t e = 0; e < kSix; ++e) x[m][e] = (x[m][e] + x[m + 1][e]) * inverse[m];
    }
}

double reflectanceAt(double z) {
    return 1 / (1 + std::exp(-2 * z));
}

/// The change of z by one step of (M19); none where the equations do not determine it.
std::optional<Spectrum> changeOf(const SixWeights& weights, const Spectrum& s, const Six& miss) {
    SixSpectra slopes;  // Jᵀ
    for (std::size_t m = 0; m < s.size(); ++m) {
        const double ds = 2 * s[m] * (1 - s[m]);
        for (std::size_t e = 0; e < kSix; ++e) slopes[m][e] = ds * weights[m][e];
    }
    SixSpectra smoothed = slopes;
    smooth(smoothed);
    SixMatrix gram{};
    for (std::size_t m = 0; m < s.size(); ++m) {
        for (std::size_t e = 0; e < kSix; ++e) {
            for (std::size_t f = 0; f < kSix; ++f) gram[e][f] += slopes[m][e] * smoothed[m][f];
        }
    }
    const auto multipliers = solveSix(gram, miss);
    if (!multipliers) return {};
    Spectrum change{};
    double steepest = 0;
    for (std::size_t m = 0; m < s.size(); ++m) {
        for (std::size_t e = 0; e < kSix; ++e) change[m] -= (*multipliers)[e] * smoothed[m][e];
        steepest = std::max(steepest, std::abs(change[m]));
    }
    constexpr double farthest = 2;  // of z in a step: beyond it (M19) says little
    for (double& value : change) value *= steepest > farthest ? farthest / steepest : 1;
    return change;
}

/// The reflectance with all six colours, if the steps arrive at it.
std::optional<Spectrum> reach(const SixWeights& weights, const Spectrum& base, const Six& target) {
    constexpr double least = 1e-15;  // of a band's distance from 0 and 1, for z to be finite
    Spectrum z;
    for (std::size_t m = 0; m < z.size(); ++m) {
        const double s = std::clamp(base[m], least, 1 - least);
        z[m] = 0.5 * std::log(s / (1 - s));
    }
    for (int i = 0; i < kMostSteps; ++i) {
        Spectrum s;
        for (std::size_t m = 0; m < z.size(); ++m) s[m] = reflectanceAt(z[m]);
        const Six miss = colorsOf(weights, s) - target;
        const double largest = largestOf(miss);
        if (largest <= kTolerance) return s;
        if (std::isnan(largest)) return {};
        const auto change = changeOf(weights, s, miss);
        if (!change) return {};
        for (std::size_t m = 0; m < z.size(); ++m) z[m] += (*change)[m];
    }
    return {};
}

/// The same on the straight way there, in lengths that are halved where they are too long.
std::optional<Spectrum> approach(const SixWeights& weights, const Spectrum& base,
                                 const Six& target) {
    const Six from = colorsOf(weights, base);
    Spectrum reached = base;
    double way = 0;
    for (double length = 0.5; length >= 1.0 / 64;) {
        const double next = std::min(1.0, way + length);
        Six between;
        for (std::size_t e = 0; e < kSix; ++e) {
            between[e] = from[e] + next * (target[e] - from[e]);
        }
        const auto found = reach(weights, reached, between);
        if (!found) {
            length /= 2;
            continue;
        }
        reached = *found;
        way = next;
        if (way == 1) return reached;
    }
    return {};
}

}  // namespace

struct SecondLamp::Weights {
    SixWeights value;
};

SecondLamp::SecondLamp(const Observer& first, const Observer& second)
    : second_(second), weights_(std::make_shared<Weights>(Weights{sixWeights(first, second)})) {}

SecondLamp::Answer SecondLamp::move(const Spectrum& base, const XYZ& second) const {
    const SixWeights& weights = weights_->value;
    Six target = colorsOf(weights, base);
    for (std::size_t c = 0; c < 3; ++c) target[3 + c] = second[int(c)];
    const auto isMet = [&](const Spectrum& s, double tolerance) {
        return largestOf(colorsOf(weights, s) - target) <= tolerance;
    };
    if (isMet(base, kTolerance)) return {base, true};  // white and black, too
    if (const auto reached = reach(weights, base, target)) return {*reached, true};
    const Spectrum nearest = nearestPair(weights, base, target).value_or(base);
    if (!isMet(nearest, kNearTolerance)) return {nearest, false};
    return {approach(weights, base, target).value_or(nearest), true};
}

}  // namespace specbake
