#include "solve/descent/face_path.h"

namespace specbake::internal {

StraightPath::StraightPath(const Weights& weights, const FreeSet& free, const Spectrum& start,
                           const Imath::V3d& residual)
    : weights_(weights),
      free_(free),
      start_(start),
      direction_(faceModes(weights, free).solve(residual)) {}

double StraightPath::value(std::size_t band, double time) const {
    return start_[band] + time * velocity(band);
}

std::optional<Hit> StraightPath::firstHit() const {
    std::optional<Hit> first;
    double end = 1;
    for (const std::size_t m : free_) {
        const double v = velocity(m);
        const double bound = v < 0 ? 0 : 1;
        if (std::abs(v) * end <= std::abs(bound - start_[m])) continue;
        end = (bound - start_[m]) / v;
        first = {m, end, bound};
    }
    return first;
}

}  // namespace specbake::internal
