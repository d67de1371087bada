#include "solve/natural/natural.h"

#include <utility>

namespace specbake::internal {

NaturalSolver::NaturalSolver(const Observer& observer, std::shared_ptr<const Solver> base,
                             const std::vector<MeasuredSet>& sets)
    : MovedSolver(observer, std::move(base)), vote_(observer, this->base(), sets) {}

Spectrum NaturalSolver::direction(const XYZ& color) const {
    return vote_.at(color);
}

}  // namespace specbake::internal
