#include "color/names.h"
#include "color/tables.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

namespace specbake {

using namespace internal;

namespace {

const tables::IlluminantTable& illuminantTable(std::string_view name) {
    for (const auto& table : tables::illuminants) {
        if (lowerCase(table.name) == lowerCase(name)) return table;
    }
    throw ArgumentError("unknown illuminant '" + std::string(name) + "'" +
                        suggestion(name, illuminantNames()));
}

/// x̄, ȳ, z̄ of a band. The quotient is the double nearest to the printed decimal: both the
/// integer and 1e10 are exact.
Imath::V3d colorMatching(std::size_t band) {
    const auto& c = tables::colorMatching[band];
    return Imath::V3d(double(c[0]), double(c[1]), double(c[2])) / 1e10;
}

}  // namespace

Observer::Observer(std::string_view illuminant) {
    const tables::IlluminantTable& table = illuminantTable(illuminant);
    illuminant_ = table.name;
    const auto& power = table.power;
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
        static_cast<void>(illuminantTable(name));
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
