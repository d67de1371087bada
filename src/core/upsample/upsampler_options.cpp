#include <specbake/core/methods.h>
#include <specbake/core/observer.h>
#include <specbake/core/upsampler_options.h>

#include <algorithm>

namespace specbake {
namespace {

bool isReflectance(const Spectrum& s) {
    return std::all_of(s.begin(), s.end(), [](double v) { return v >= 0 && v <= 1; });
}

std::string bandsProblem(const UpsamplerOptions& options) {
    if (options.quadrature == Quadrature::bands && options.bands != Wavelengths()) {
        return "the quadrature of other bands than 380:780:5 is the fine one";
    }
    return wavelengthsProblem(options.bands);
}

/// What is wrong; empty if nothing is.
std::string problemOf(const UpsamplerOptions& options) {
    std::string problem;
    if (options.illuminant && !isIlluminant(*options.illuminant, &problem)) return problem;
    if (!isObserver(options.observer, &problem)) return problem;
    const auto kinds = adaptations();
    if (std::find(kinds.begin(), kinds.end(), options.adapt) == kinds.end()) {
        return "an adaptation of no kind";
    }
    if (findMethod(options.method) == nullptr) return "unknown method '" + options.method + "'";
    const auto materials = materialNames();
    if (options.material &&
        std::find(materials.begin(), materials.end(), *options.material) == materials.end()) {
        return "unknown material '" + *options.material + "'";
    }
    if (options.samples.size() > kMostSamples) {
        return "at most " + std::to_string(kMostSamples) + " samples, not " +
               std::to_string(options.samples.size());
    }
    for (const MeasuredSample& sample : options.samples) {
        if (!isReflectance(sample.reflectance)) {
            return "the sample '" + sample.name + "' is no reflectance: it leaves [0, 1]";
        }
    }
    problem = bandsProblem(options);
    if (!problem.empty()) return problem;
    if (options.grid && (*options.grid < kFewestGridNodes || *options.grid > kMostGridNodes)) {
        return "a grid has " + std::to_string(kFewestGridNodes) + " to " +
               std::to_string(kMostGridNodes) + " nodes an axis, not " +
               std::to_string(*options.grid);
    }
    return {};
}

}  // namespace

bool UpsamplerOptions::isValid(std::string* reason) const {
    std::string problem = problemOf(*this);
    const bool valid = problem.empty();
    if (reason != nullptr) *reason = std::move(problem);
    return valid;
}

}  // namespace specbake
