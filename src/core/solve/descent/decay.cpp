#include "solve/descent/decay.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace specbake::internal {
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

struct Sample {
    double value;
    double slope;
};

/// The root of a function that is monotone on [low, high] and has different signs at its ends:
/// Newton from `low`, bisection where a step leaves the bracket or is not half of the one before.
/// Ends when the bracket or the step is down to rounding.
template <class Function>
double monotoneRoot(const Function& function, double low, double high) {
    constexpr double epsilon = 2 * std::numeric_limits<double>::epsilon();
    Sample at = function(low);
    const bool positiveAtLow = at.value > 0;
    double x = low;
    double step = high - low;
    while (at.value != 0 && high - low > epsilon * high) {
        double next = x - at.value / at.slope;
        if (!(next > low && next < high) || std::abs(next - x) > step / 2) {
            next = low + (high - low) / 2;
        }
        step = std::abs(next - x);
        x = next;
        if (step <= epsilon * x) break;
        at = function(x);
        ((at.value > 0) == positiveAtLow ? low : high) = x;
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

    Sample at(double time) const {
        const double second = b2 * std::exp(-d2 * time);
        const double third = b3 * std::exp(-d3 * time);
        return {b1 + second + third, -d2 * second - d3 * third};
    }
    /// Where its own slope is 0; infinite or NaN where it never is.
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
        if (g.at(low).value * g.at(high).value < 0) {
            knots.add(monotoneRoot([&](double t) { return g.at(t); }, low, high));
        }
        low = high;
    }
    if (knots.back() < end) knots.add(end);
    return knots;
}

/// value - bound, and the slope.
Sample excessOver(double bound, const Decay& decay, double time) {
    Sample sample{decay.start - bound, 0};
    for (int k = 0; k < 3; ++k) {
        const double fall = std::expm1(-decay.rates[k] * time);
        sample.value += decay.amplitudes[k] * fall;
        sample.slope -= decay.rates[k] * decay.amplitudes[k] * (1 + fall);
    }
    return sample;
}

}  // namespace

double Decay::value(double time) const {
    return start + amplitudes.x * std::expm1(-rates.x * time) +
           amplitudes.y * std::expm1(-rates.y * time) + amplitudes.z * std::expm1(-rates.z * time);
}

std::optional<Exit> firstExit(const Decay& decay, double end) {
    double low = 0;
    for (const double high : monotonePieces(decay, end)) {
        const double value = decay.value(high);
        if (value < 0 || value > 1) {
            const double bound = value < 0 ? 0 : 1;
            const auto excess = [&](double t) { return excessOver(bound, decay, t); };
            return Exit{monotoneRoot(excess, low, high), bound};
        }
        low = high;
    }
    return std::nullopt;
}

}  // namespace specbake::internal
