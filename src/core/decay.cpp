#include "decay.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace specbake {
namespace {

/// At most four times in ascending order, the ends of monotone pieces.
class Knots {
  public:
    explicit Knots(double first) { add(first); }
    void add(double time) { times_[count_++] = time; }
    double back() const { return times_[count_ - 1]; }
    auto begin() const { return times_.begin(); }
    auto end() const { return times_.begin() + std::ptrdiff_t(count_); }

  private:
    std::array<double, 4> times_{};
    std::size_t count_ = 0;
};

/// The root of a function that is monotone on [low, high] and has different signs at its ends:
/// Newton from `low`, bisection where a step leaves the bracket or does not halve it in two.
/// Ends when the bracket or the step is down to rounding.
template <class Function, class Slope>
double monotoneRoot(const Function& function, const Slope& slope, double low, double high) {
    const double atLow = function(low);
    if (atLow == 0) return low;
    const double epsilon = 2 * std::numeric_limits<double>::epsilon();
    double x = low;
    double value = atLow;
    double previousStep = high - low;
    while (high - low > epsilon * high) {
        double next = x - value / slope(x);
        if (!(next > low && next < high) || std::abs(next - x) > previousStep / 2) {
            next = low + (high - low) / 2;
        }
        previousStep = std::abs(next - x);
        x = next;
        value = function(x);
        if (value == 0 || previousStep <= epsilon * x) break;
        ((value > 0) == (atLow > 0) ? low : high) = x;
    }
    return x;
}

/// The slope over exp(-rate_1 t): b_1 + b_2 exp(-d_2 t) + b_3 exp(-d_3 t). It has the slope's
/// zeros, and does not fade before the slowest mode does.
struct ScaledSlope {
    double b1, b2, b3, d2, d3;

    explicit ScaledSlope(const Decay& decay)
        : b1(-decay.rates.x * decay.amplitudes.x),
          b2(-decay.rates.y * decay.amplitudes.y),
          b3(-decay.rates.z * decay.amplitudes.z),
          d2(decay.rates.y - decay.rates.x),
          d3(decay.rates.z - decay.rates.x) {}

    double value(double time) const {
        return b1 + b2 * std::exp(-d2 * time) + b3 * std::exp(-d3 * time);
    }
    double slope(double time) const {
        return -d2 * b2 * std::exp(-d2 * time) - d3 * b3 * std::exp(-d3 * time);
    }
    /// Where slope() is 0; infinite or NaN where it never is.
    double turningTime() const { return std::log(-(d3 * b3) / (d2 * b2)) / (d3 - d2); }
};

/// 0, the zeros of the decay's slope within (0, end), end.
Knots monotonePieces(const Decay& decay, double end) {
    const ScaledSlope g(decay);
    const double turn = g.turningTime();
    Knots pieces(0);  // of g
    if (turn > 0 && turn < end) pieces.add(turn);
    pieces.add(end);

    Knots knots(0);
    double low = 0;
    for (const double high : pieces) {
        if (g.value(low) * g.value(high) < 0) {
            knots.add(monotoneRoot([&](double t) { return g.value(t); },
                                   [&](double t) { return g.slope(t); }, low, high));
        }
        low = high;
    }
    if (knots.back() < end) knots.add(end);
    return knots;
}

}  // namespace

double Decay::value(double time) const {
    return start + amplitudes.x * std::expm1(-rates.x * time) +
           amplitudes.y * std::expm1(-rates.y * time) + amplitudes.z * std::expm1(-rates.z * time);
}

double Decay::slope(double time) const {
    return -rates.x * amplitudes.x * std::exp(-rates.x * time) -
           rates.y * amplitudes.y * std::exp(-rates.y * time) -
           rates.z * amplitudes.z * std::exp(-rates.z * time);
}

std::optional<Exit> firstExit(const Decay& decay, double end) {
    double low = 0;
    for (const double high : monotonePieces(decay, end)) {
        const double value = decay.value(high);
        if (value < 0 || value > 1) {
            const double bound = value < 0 ? 0 : 1;
            const double time = monotoneRoot([&](double t) { return decay.value(t) - bound; },
                                             [&](double t) { return decay.slope(t); }, low, high);
            return Exit{time, bound};
        }
        low = high;
    }
    return std::nullopt;
}

}  // namespace specbake
