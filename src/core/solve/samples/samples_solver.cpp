#include "solve/samples/samples_solver.h"

#include "solve/natural/place.h"

#include <specbake/core/ciede2000.h>

#include <algorithm>
#include <utility>

namespace specbake::internal {
namespace {

/// Samples beside what a solver makes of their colours.
struct Missed {
    std::vector<Imath::V3d> places;
    std::vector<Spectrum> solved;
    std::vector<Spectrum> blacks;  ///< b_k
};

Missed missedBy(const Solver& base, const Observer& observer,
                const std::vector<MeasuredSample>& samples) {
    std::vector<XYZ> colors;
    for (const MeasuredSample& s : samples) colors.push_back(observer.color(s.reflectance));
    std::vector<Solution> solutions(colors.size());
    base.solveMany(colors, solutions);
    Missed missed;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        if (!solutions[k].solved()) continue;
        missed.places.push_back(placeOf(colors[k], observer.white()));
        missed.solved.push_back(solutions[k].spectrum);
        Spectrum& black = missed.blacks.emplace_back(samples[k].reflectance);
        for (std::size_t m = 0; m < black.size(); ++m) black[m] -= solutions[k].spectrum[m];
    }
    return missed;
}

SampleField fieldOf(Missed missed, const FieldShape& shape) {
    return {std::move(missed.places), missed.blacks, shape};
}

/// Every n-th, so that at most 256 are left.
std::vector<MeasuredSample> thinned(const std::vector<MeasuredSample>& samples) {
    constexpr std::size_t most = 256;
    const std::size_t stride = (samples.size() + most - 1) / most;
    std::vector<MeasuredSample> some;
    for (std::size_t i = 0; i < samples.size(); i += stride) some.push_back(samples[i]);
    return some;
}

/// Mean CIEDE2000, under a lamp, of the samples and the base's spectra moved by `moves`.
double difference(const Observer& lamp, const Missed& missed, const std::vector<Spectrum>& moves) {
    double sum = 0;
    for (std::size_t k = 0; k < moves.size(); ++k) {
        const Spectrum rebuilt = movedWithinBounds(missed.solved[k], moves[k]);
        const Spectrum sample = movedWithinBounds(missed.solved[k], missed.blacks[k]);
        sum += ciede2000(labFromXYZ(lamp.color(rebuilt), lamp.white()),
                         labFromXYZ(lamp.color(sample), lamp.white()));
    }
    return moves.empty() ? 0 : sum / double(moves.size());
}

}  // namespace

SamplesSolver::SamplesSolver(const Observer& observer, std::shared_ptr<const Solver> base,
                             const std::vector<MeasuredSample>& samples, const FieldShape& shape)
    : MovedSolver(observer, std::move(base)),
      field_(fieldOf(missedBy(this->base(), observer, samples), shape)) {}

Spectrum SamplesSolver::direction(const XYZ& color) const {
    return field_.at(placeOf(color, observer().white()));
}

ShapeChoice chooseShape(const Observer& observer, const Solver& base,
                        const std::vector<MeasuredSample>& samples) {
    const Missed missed = missedBy(base, observer, thinned(samples));
    ShapeChoice best;
    best.samples = missed.places.size();
    best.light = observer.illuminant() == "A" ? "D65" : "A";
    const Observer lamp(best.light, observer.quadrature(), observer.bands());
    best.without = difference(lamp, missed, std::vector<Spectrum>(best.samples));
    const auto judged = [&](const FieldShape& shape) {
        return difference(lamp, missed, fieldOf(missed, shape).leftOut(missed.blacks));
    };
    best.difference = judged(best.shape);
    for (const double range : {4.0, 8.0, 16.0, 32.0}) {
        for (const double weight : {0.0, 0.1, 0.3, 1.0}) {
            const double found = judged({range, weight});
            if (found >= best.difference) continue;
            best.shape = {range, weight};
            best.difference = found;
        }
    }
    return best;
}

}  // namespace specbake::internal
