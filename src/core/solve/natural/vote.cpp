#include "solve/natural/vote.h"

#include "solve/natural/place.h"
#include "solve/natural/weighted_sum.h"

#include <cmath>

namespace specbake::internal {
namespace {

double square(double x) {
    return x * x;
}

void scale(Spectrum& s, double factor) {
    for (double& value : s) value *= factor;
}

/// |a − b|²
double squaredDistance(const Spectrum& a, const Spectrum& b) {
    double sum = 0;
    for (std::size_t m = 0; m < a.size(); ++m) sum += square(a[m] - b[m]);
    return sum;
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
            blacks.places.push_back(placeOf(colors[k], white_));
            const Weighted found{-1, &solutions[k].spectrum};
            Spectrum& black = blacks.differences.emplace_back(samples[k].reflectance);
            addWeighted({&found, 1}, black);
        }
    }
}

Vote::LocalMean Vote::localMean(const Blacks& set, const Imath::V3d& place) {
    constexpr double negligible = 0x1p-40;  // of a vote that changes a reflectance by 1 at most
    const double farthest = -2 * square(kWidth) * std::log(negligible);
    std::vector<Weighted> near;
    double mass = 0;  // m_j
    for (std::size_t k = 0; k < set.places.size(); ++k) {
        const double distance = (place - set.places[k]).length2();
        if (distance > farthest) continue;
        const double weight = std::exp(-distance / (2 * square(kWidth)));  // K_k
        near.push_back({weight, &set.differences[k]});
        mass += weight;
    }
    LocalMean local;
    if (mass == 0) return local;
    for (Weighted& black : near) black.weight /= mass;
    addWeighted(near, local.mean);
    local.vote = mass / (mass + kHalfVote);
    return local;
}

Spectrum Vote::at(const XYZ& color) const {
    const Imath::V3d place = placeOf(color, white_);
    std::vector<LocalMean> locals;
    double votes = 0;  // Q
    for (const Blacks& set : sets_) {
        votes += locals.emplace_back(localMean(set, place)).vote;
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
