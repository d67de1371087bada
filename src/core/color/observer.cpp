#include "color/named_light.h"
#include "color/names.h"
#include "color/tables.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

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
