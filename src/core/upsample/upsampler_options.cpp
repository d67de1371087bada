#include <specbake/core/methods.h>
#include <specbake/core/upsampler_options.h>

#include <algorithm>

namespace specbake {
namespace {

/// What is wrong; empty if nothing is.
std::string problemOf(const UpsamplerOptions& options) {
    const auto& lights = illuminantNames();
    if (options.illuminant &&
        std::find(lights.begin(), lights.end(), *options.illuminant) == lights.end()) {
        return "unknown illuminant '" + *options.illuminant + "'";
    }
    if (findMethod(options.method) == nullptr) return "unknown method '" + options.method + "'";
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
