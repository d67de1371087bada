#include <specbake/bake/bake.h>
#include <specbake/core/observer.h>

#include <cmath>

namespace specbake {
namespace {

bool isPositive(const std::optional<double>& limit) {
    return !limit || (std::isfinite(*limit) && *limit > 0);
}

std::string problemOfMap(const BakeOptions& options) {
    const std::vector<std::string>& materials = options.mappedMaterials;
    if (options.materialMap.has_value() != !materials.empty()) {
        return "a map of materials needs the materials, and these a map";
    }
    if (materials.size() > BakeOptions::kMostMapped) {
        return "a map has at most " + std::to_string(BakeOptions::kMostMapped) + " materials";
    }
    if (options.materialMap && options.model.material) {
        return "a map of materials leaves none to the model";
    }
    UpsamplerOptions model = options.model;
    std::string problem;
    for (const std::string& material : materials) {
        model.material = material;
        if (!model.isValid(&problem)) return problem;
    }
    return {};
}

std::string problemOfSecond(const BakeOptions& options) {
    if (options.second.has_value() != !options.secondLight.empty()) {
        return "a texture under a second light needs the light, and this the texture";
    }
    std::string reason;
    if (options.second && !isIlluminant(options.secondLight, &reason)) return reason;
    if (options.second && options.model.bands != Wavelengths()) {
        return "a texture under a second light is for the bands 380:780:5";
    }
    return {};
}

std::string problemOfBits(const BakeOptions& options) {
    if (options.maxDE && (options.materialMap || options.second)) {
        return "bits are chosen by CIEDE2000 for a texture alone, not with an image beside it";
    }
    return {};
}

/// What is wrong; empty if nothing is.
std::string problemOf(const BakeOptions& options) {
    std::string problem = problemOfMap(options);
    if (problem.empty()) problem = problemOfSecond(options);
    if (problem.empty()) problem = problemOfBits(options);
    if (!problem.empty()) return problem;
    if (!options.read.isValid(&problem)) return problem;
    if (!options.color.isValid(&problem)) return problem;
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
    for (const auto& [name, value] : options.attributes) {
        if (!isFreeAttributeName(name)) {
            return "an attribute cannot be called '" + name +
                   "': names have 1 to 31 characters and are none that the file's format, "
                   "OpenImageIO or specbake gives a meaning";
        }
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
