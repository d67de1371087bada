#include "solve/descent/face_path.h"

#include <algorithm>
#include <cmath>

namespace specbake::internal {

namespace {

/// A bound on the decay over [0, end] that needs no root: each term is monotone, so it moves
/// between 0 and amplitude_k (exp(-rate_k end) - 1); `fall` holds the brackets.
bool staysInside(const Decay& decay, const Imath::V3d& fall) {
    double low = decay.start;
    double high = decay.start;
    for (int k = 0; k < 3; ++k) {
        const double change = decay.amplitudes[k] * fall[k];
        (change < 0 ? low : high) += change;
    }
    return low > 0 && high < 1;
}

Imath::V3d fallUntil(const Imath::V3d& rates, double end) {
    return {std::expm1(-rates.x * end), std::expm1(-rates.y * end), std::expm1(-rates.z * end)};
}

}  // namespace

FlowPath::FlowPath(const Weights& weights, const FreeSet& free, const Spectrum& start,
                   const Imath::V3d& residual)
    : weights_(weights), free_(free), start_(start), residual_(residual) {
    const FaceModes modes = faceModes(weights, free);
    rates_ = modes.rates;
    for (unsigned k = 3; k-- > 0;) {
        const double rate = rates_[int(k)];
        if (!(rate > modes.cutoff())) continue;  // not reached from this face: no motion
        modes_[k] = modes.vectors[k] * (modes.vectors[k].dot(residual) / rate);
        end_ = 64 / rate;
    }
}

Decay FlowPath::component(std::size_t band) const {
    const Imath::V3d& w = weights_[band];
    return {start_[band], {w.dot(modes_[0]), w.dot(modes_[1]), w.dot(modes_[2])}, rates_};
}

double FlowPath::velocity(std::size_t band) const {
    return -weights_[band].dot(residual_);
}

double FlowPath::timeBeyondHit() const {
    for (double time = 1 / (8 * rates_.z); time < end_; time *= 2) {
        const Imath::V3d fall = fallUntil(rates_, time);
        const Imath::V3d move = modes_[0] * fall.x + modes_[1] * fall.y + modes_[2] * fall.z;
        for (const std::size_t m : free_) {
            const double s = start_[m] + weights_[m].dot(move);
            if (s < 0 || s > 1) return time;
        }
    }
    return end_;
}

std::optional<Hit> FlowPath::firstHit() const {
    std::optional<Hit> first;
    double end = timeBeyondHit();
    Imath::V3d fall = fallUntil(rates_, end);
    for (const std::size_t m : free_) {
        const Decay decay = component(m);
        if (staysInside(decay, fall)) continue;
        const std::optional<Exit> exit = firstExit(decay, end);
        if (!exit) continue;
        first = {m, exit->time, exit->bound};
        end = exit->time;
        fall = fallUntil(rates_, end);
    }
    return first;
}

}  // namespace specbake::internal
