#include "solve/natural/vote.h"

#include "solve/natural/place.h"
#include "solve/natural/weighted_sum.h"

#include <array>
#include <numeric>

namespace specbake::internal {
namespace {

double square(double x) {
    return x * x;
}

void scale(Spectrum& s, double factor) {
    for (double& value : s) value *= factor;
}

/// |a − b|², by sums that do not wait for each other.
double squaredDistance(const Spectrum& a, const Spectrum& b) {
    constexpr std::size_t last = kBandCount - 1;
    std::array<double, 8> sums{};
    static_assert(last % sums.size() == 0);
    for (std::size_t m = 0; m < last; m += sums.size()) {
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += square(a[m + i] - b[m + i]);
    }
    return std::accumulate(sums.begin(), sums.end(), square(a[last] - b[last]));
}

/// φ: 0 for greys and for black.
double fade(const Imath::V3d& place) {
    constexpr double halfChroma = 2;
    constexpr double halfLightness = 10.0 / 2;  // of L*/2
    const double chroma = square(place.y) + square(place.z);
    const double lightness = square(place.x);
    return chroma / (chroma + square(halfChroma)) * lightness / (lightness + square(halfLightness));
}

}  // namespace

Vote::Vote(const Observer& observer, const Solver& solver, const std::vector<MeasuredSet>& sets)
    : white_(observer.white()) {
    for (const MeasuredSet& set : sets) {
        const std::vector<MeasuredSample> samples = atKnots(set.samples, observer.knots());
        std::vector<XYZ> colors;
        for (const MeasuredSample& s : samples) colors.push_back(observer.color(s.reflectance));
        std::vector<Solution> solutions(colors.size());
        solver.solveMany(colors, solutions);
        Blacks& blacks = sets_.emplace_back();
        for (std::size_t k = 0; k < colors.size(); ++k) {
            if (!solutions[k].solved()) continue;
            blacks.places.add(placeOf(colors[k], white_));
            const Weighted found{-1, &solutions[k].spectrum};
            Spectrum& black = blacks.differences.emplace_back(samples[k].reflectance);
            addWeighted({&found, 1}, black);
        }
    }
}

Vote::LocalMean Vote::localMean(const Blacks& set, const Imath::V3d& place, Near& near) {
    weighNear(set.places, place, kWidth, near);
    const double mass = std::accumulate(near.weights.begin(), near.weights.end(), 0.0);  // m_j
    LocalMean local;
    if (mass == 0) return local;
    std::vector<Weighted> blacks;
    blacks.reserve(near.weights.size());
    for (std::size_t i = 0; i < near.weights.size(); ++i) {
        blacks.push_back({near.weights[i] / mass, &set.differences[near.indices[i]]});
    }
    addWeighted(blacks, local.mean);
    local.vote = mass / (mass + kHalfVote);
    return local;
}

Spectrum Vote::at(const XYZ& color) const {
    const Imath::V3d place = placeOf(color, white_);
    std::vector<LocalMean> locals;
    Near near;
    double votes = 0;  // Q
    for (const Blacks& set : sets_) {
        votes += locals.emplace_back(localMean(set, place, near)).vote;
    }
    if (votes == 0) return {};
    std::vector<Weighted> terms;
    for (const LocalMean& local : locals) terms.push_back({local.vote / votes, &local.mean});
    Spectrum mean{};  // b̄
    addWeighted(terms, mean);
    double variance = 0;  // V
    for (const LocalMean& local : locals) {
        variance += local.vote * squaredDistance(local.mean, mean) / votes;
    }
    const double size = squaredDistance(mean, {});  // |b̄|²
    if (size == 0) return {};
    const double agreement = size / (size + kDoubt * variance / votes);
    scale(mean, fade(place) * votes / (votes + kHalfBelief) * agreement);
    return mean;
}

}  // namespace specbake::internal
