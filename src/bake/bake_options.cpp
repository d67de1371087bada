#include <specbake/bake/bake.h>

#include <cmath>

namespace specbake {
namespace {

bool isPositive(const std::optional<double>& limit) {
    return !limit || (std::isfinite(*limit) && *limit > 0);
}

/// What is wrong; empty if nothing is.
std::string problemOf(const BakeOptions& options) {
    std::string problem;
    if (!options.read.isValid(&problem)) return problem;
    if (!options.model.isValid(&problem)) return problem;
    if (options.bits < BakeOptions::kFewestMantissaBits ||
        options.bits > BakeOptions::kMostMantissaBits) {
        return "a half's mantissa is rounded to " +
               std::to_string(BakeOptions::kFewestMantissaBits) + " to " +
               std::to_string(BakeOptions::kMostMantissaBits) + " bits";
    }
    if (!isPositive(options.maxDeviation) || !isPositive(options.maxDE)) {
        return "the largest deviation or difference must be a number above 0";
    }
    if (options.threads < 0) return "a number of threads below 0";
    return {};
}

}  // namespace

bool BakeOptions::isValid(std::string* reason) const {
    std::string problem = problemOf(*this);
    const bool valid = problem.empty();
    if (reason != nullptr) *reason = std::move(problem);
    return valid;
}

}  // namespace specbake
