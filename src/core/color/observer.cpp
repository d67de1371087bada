#include "color/knot_place.h"
#include "color/matching.h"
#include "color/named_light.h"
#include "color/tables.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace specbake {

using namespace internal;

namespace {

/// Bands that are linear between knots weigh on these.
std::vector<Imath::V3d> foldedToKnots(const std::vector<Imath::V3d>& weights,
                                      const Wavelengths& bands) {
    const Wavelengths knots = bands.knots();
    if (knots == bands) return weights;
    std::vector<Imath::V3d> folded(std::size_t(knots.count), Imath::V3d(0.0));
    for (std::size_t m = 0; m < weights.size(); ++m) {
        const auto [below, ofNext] = placeOn(knots, bands.at(int(m)));
        folded[below] += weights[m] * (1 - ofNext);
        folded[below + 1] += weights[m] * ofNext;
    }
    return folded;
}

using Weights = std::array<Imath::V3d, kBandCount>;

Weights bandWeights(const ColorMatching& functions, const LightPower& power) {
    double luminance = 0;
    for (std::size_t m = 0; m < power.size(); ++m) luminance += power[m] * functions.at(m).y;
    if (!(luminance > 0)) throw ArgumentError("a light that the observer does not see");
    Weights weights;
    for (std::size_t m = 0; m < weights.size(); ++m) {
        weights[m] = functions.at(m) * (power[m] / luminance);
    }
    return weights;
}

/// Those of the fine quadrature, in whole units.
Weights knotWeights(const std::vector<Imath::V3d>& ofBands, const Wavelengths& bands) {
    Weights weights;
    weights.fill(Imath::V3d(0.0));
    const auto atKnots = foldedToKnots(ofBands, bands);
    for (std::size_t m = 0; m < atKnots.size(); ++m) {
        for (int i = 0; i < 3; ++i) {
            weights[m][i] =
                std::nearbyint(atKnots[m][i] / Observer::kWeightUnit) * Observer::kWeightUnit;
        }
    }
    return weights;
}

}  // namespace

Observer::Observer(std::string_view illuminant)
    : Observer(illuminant, Quadrature::bands, Wavelengths()) {}

Observer::Observer(std::string_view illuminant, Quadrature quadrature, const Wavelengths& bands,
                   std::string_view functions)
    : quadrature_(quadrature), bands_(bands) {
    NamedLight light = lightNamed(illuminant);
    const auto matching = matchingNamed(functions);
    illuminant_ = std::move(light.name);
    functions_ = matching->name;
    if (quadrature == Quadrature::bands) {
        if (bands != Wavelengths()) {
            throw ArgumentError("the sum over the bands is that of 380 to 780 nm every 5 nm");
        }
        weights_ = bandWeights(*matching, light.power);
    } else {
        const std::string problem = wavelengthsProblem(bands);
        if (!problem.empty()) throw ArgumentError(problem);
        weights_ = knotWeights(fineWeights(illuminant_, listed(bands), functions_), bands);
    }
    white_ = color(constantSpectrum(1));
}

std::string Observer::name() const {
    const auto& names = observerNames();
    if (std::find(names.begin(), names.end(), functions_) == names.end()) return functions_;
    return functions_ + (quadrature_ == Quadrature::bands ? ", 5 nm" : ", 1 nm");
}

XYZ Observer::color(const Spectrum& reflectance) const {
    Imath::V3d sum(0.0);
    for (std::size_t m = 0; m < weights_.size(); ++m) sum += weights_[m] * reflectance[m];
    return XYZ(sum);
}

bool isIlluminant(std::string_view name, std::string* reason) {
    try {
        static_cast<void>(lightNamed(name));
        return true;
    } catch (const ArgumentError& error) {
        if (reason != nullptr) *reason = error.what();
        return false;
    }
}

const std::vector<std::string>& illuminantNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const auto& table : tables::illuminants) list.emplace_back(table.name);
        return list;
    }();
    return names;
}

}  // namespace specbake
