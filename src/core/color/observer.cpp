#include "color/named_light.h"
#include "color/names.h"
#include "color/tables.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <cmath>

namespace specbake {

using namespace internal;

namespace {

NamedLight lightNamed(std::string_view name) {
    if (auto light = findLight(name)) return *std::move(light);
    std::vector<std::string> names = illuminantNames();
    const auto& further = furtherIlluminantNames();
    names.insert(names.end(), further.begin(), further.end());
    throw ArgumentError("unknown illuminant '" + std::string(name) + "'" + suggestion(name, names));
}

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
        const double place = (bands.at(int(m)) - knots.first) / knots.step;
        const double below = std::clamp(std::floor(place), 0.0, double(knots.count - 2));
        const double ofNext = std::clamp(place - below, 0.0, 1.0);
        folded[std::size_t(below)] += weights[m] * (1 - ofNext);
        folded[std::size_t(below) + 1] += weights[m] * ofNext;
    }
    return folded;
}

}  // namespace

std::array<double, 95> internal::tables::finePower(std::string_view light) {
    const NamedLight named = lightNamed(light);
    const LightPower& middle = named.power;
    std::array<double, 95> all;
    std::fill_n(all.begin(), 4, middle.front());
    std::copy(middle.begin(), middle.end(), all.begin() + 4);
    std::fill(all.begin() + 85, all.end(), middle.back());
    for (const auto& ends : tables::kIlluminantEnds) {
        if (ends.name != named.name) continue;
        for (std::size_t i = 0; i < 14; ++i) {
            const double power = i < 4 ? ends.below[i] : ends.above[i - 4];
            if (!std::isnan(power)) all[i < 4 ? i : i + 81] = power;
        }
    }
    return all;
}

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
