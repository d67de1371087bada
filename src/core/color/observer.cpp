#include "color/knot_place.h"
#include "color/named_light.h"
#include "color/tables.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <cmath>

namespace specbake {

using namespace internal;

namespace {

/// x̄, ȳ, z̄ of a band. The quotient is the double nearest to the printed decimal: both the
/// integer and 1e10 are exact.
Imath::V3d colorMatching(std::size_t band) {
    const auto& c = tables::colorMatching[band];
    return Imath::V3d(double(c[0]), double(c[1]), double(c[2])) / 1e10;
}

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

}  // namespace

Observer::Observer(std::string_view illuminant) {
    NamedLight light = lightNamed(illuminant);
    illuminant_ = std::move(light.name);
    const LightPower& power = light.power;
    double luminance = 0;
    for (std::size_t m = 0; m < weights_.size(); ++m) luminance += power[m] * colorMatching(m).y;
    for (std::size_t m = 0; m < weights_.size(); ++m) {
        weights_[m] = colorMatching(m) * (power[m] / luminance);
    }
    white_ = color(constantSpectrum(1));
}

Observer::Observer(std::string_view illuminant, Quadrature quadrature, const Wavelengths& bands)
    : illuminant_(lightNamed(illuminant).name), quadrature_(quadrature), bands_(bands) {
    if (quadrature == Quadrature::bands) {
        if (bands != Wavelengths()) {
            throw ArgumentError("the sum over the bands is that of 380 to 780 nm every 5 nm");
        }
        *this = Observer(illuminant);
        return;
    }
    const std::string problem = wavelengthsProblem(bands);
    if (!problem.empty()) throw ArgumentError(problem);
    weights_.fill(Imath::V3d(0.0));
    const auto atKnots = foldedToKnots(fineWeights(illuminant, listed(bands)), bands);
    for (std::size_t m = 0; m < atKnots.size(); ++m) {
        for (int i = 0; i < 3; ++i) {
            weights_[m][i] = std::nearbyint(atKnots[m][i] / kWeightUnit) * kWeightUnit;
        }
    }
    white_ = color(constantSpectrum(1));
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
