#include "color/further_lights.h"
#include "color/named_light.h"
#include "color/names.h"
#include "color/tables.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

/// The table of further lights, a column each.
std::vector<NamedLight> readFurther() {
    std::istringstream in{std::string(tables::kFurtherLights)};
    std::vector<NamedLight> lights;
    std::size_t row = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream cells(line);
        std::string cell;
        std::getline(cells, cell, ',');  // the wavelength
        for (std::size_t column = 0; std::getline(cells, cell, ','); ++column) {
            if (row == 0) {
                lights.push_back({cell, {}});
            } else {
                std::from_chars(cell.data(), cell.data() + cell.size(),
                                lights.at(column).power.at(row - 1));
            }
        }
        ++row;
    }
    return lights;
}

const std::vector<NamedLight>& furtherLights() {
    static const std::vector<NamedLight> lights = readFurther();
    return lights;
}

constexpr std::string_view kMark = ": ";  ///< between the label and the powers

void check(std::span<const LightSample> samples) {
    if (samples.size() < 2) throw ArgumentError("a light of fewer than two samples");
    bool dark = true;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto [wavelength, power] = samples[i];
        if (!std::isfinite(wavelength) || !std::isfinite(power) || power < 0) {
            throw ArgumentError("a light's powers are finite numbers of at least 0");
        }
        if (i > 0 && !(wavelength > samples[i - 1].wavelength)) {
            throw ArgumentError("a light's wavelengths ascend");
        }
        dark = dark && power == 0;
    }
    if (samples.front().wavelength > 400 || samples.back().wavelength < 700) {
        throw ArgumentError("a light's samples reach from 400 nm or less to 700 nm or more");
    }
    if (dark) throw ArgumentError("a light without power");
}

/// Linear between samples.
double powerAt(std::span<const LightSample> samples, double wavelength) {
    const auto above =
        std::lower_bound(samples.begin(), samples.end(), wavelength,
                         [](const LightSample& s, double w) { return s.wavelength < w; });
    if (above == samples.end()) return samples.back().power;
    if (above == samples.begin() || above->wavelength == wavelength) return above->power;
    const LightSample& below = *(above - 1);
    const double share = (wavelength - below.wavelength) / (above->wavelength - below.wavelength);
    return below.power + share * (above->power - below.power);
}

/// The mean around a band; nothing if there are no samples but at most one at the band itself.
std::optional<double> meanAround(std::span<const LightSample> samples, double wavelength) {
    double sum = 0;
    double weights = 0;
    int count = 0;
    for (const LightSample& s : samples) {
        const double weight = 1 - std::abs(s.wavelength - wavelength) / kWavelengthStep;
        if (weight <= 0) continue;
        sum += weight * s.power;
        weights += weight;
        ++count;
    }
    if (count < 2) return {};
    return sum / weights;
}

/// As wide as the bands or wider.
bool isCoarse(std::span<const LightSample> samples) {
    const double span = samples.back().wavelength - samples.front().wavelength;
    return span / double(samples.size() - 1) > 0.999 * kWavelengthStep;
}

bool sameLight(const LightPower& a, const LightPower& b) {
    const double factor =
        *std::max_element(a.begin(), a.end()) / *std::max_element(b.begin(), b.end());
    for (std::size_t m = 0; m < a.size(); ++m) {
        const double scaled = factor * b[m];
        if (!(std::abs(a[m] - scaled) <= 1e-9 * std::max(std::abs(a[m]), std::abs(scaled)))) {
            return false;
        }
    }
    return true;
}

std::optional<LightPower> parsed(std::string_view text) {
    LightPower power{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (double& value : power) {
        while (at != end && *at == ' ') ++at;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || !std::isfinite(value) || value < 0) return {};
        at = next;
    }
    const bool dark = std::all_of(power.begin(), power.end(), [](double p) { return p == 0; });
    return at == end && !dark ? std::optional(power) : std::nullopt;
}

}  // namespace

const std::vector<std::string>& furtherIlluminantNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const NamedLight& light : furtherLights()) list.push_back(light.name);
        return list;
    }();
    return names;
}

LightPower lightPower(std::span<const LightSample> samples) {
    check(samples);
    const bool coarse = isCoarse(samples);
    LightPower power{};
    for (int m = 0; m < kBandCount; ++m) {
        const double at = wavelength(m);
        const auto mean = coarse ? std::nullopt : meanAround(samples, at);
        power[std::size_t(m)] = mean ? *mean : powerAt(samples, at);
    }
    return power;
}

std::string lightText(std::string_view label, const LightPower& power) {
    for (const auto& table : tables::illuminants) {
        if (sameLight(power, table.power)) return std::string(table.name);
    }
    for (const NamedLight& light : furtherLights()) {
        if (sameLight(power, light.power)) return light.name;
    }
    std::string text(label);
    for (char& c : text) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    text += ':';
    for (const double value : power) text += ' ' + decimal(value);
    return text;
}

std::optional<NamedLight> internal::findLight(std::string_view text) {
    const std::size_t mark = text.rfind(kMark);
    if (mark != std::string_view::npos) {
        const auto power = parsed(text.substr(mark + kMark.size()));
        if (power) return NamedLight{std::string(text), *power};
    }
    const std::string name = lowerCase(text);
    for (const auto& table : tables::illuminants) {
        if (lowerCase(table.name) == name) return NamedLight{std::string(table.name), table.power};
    }
    for (const NamedLight& light : furtherLights()) {
        if (lowerCase(light.name) == name) return light;
    }
    return {};
}

NamedLight internal::lightNamed(std::string_view name) {
    if (auto light = findLight(name)) return *std::move(light);
    std::vector<std::string> names = illuminantNames();
    const auto& further = furtherIlluminantNames();
    names.insert(names.end(), further.begin(), further.end());
    throw ArgumentError("unknown illuminant '" + std::string(name) + "'" + suggestion(name, names));
}

std::optional<LightPower> powerOfLight(std::string_view illuminant) {
    const auto light = findLight(illuminant);
    return light ? std::optional(light->power) : std::nullopt;
}

std::string_view lightLabel(std::string_view illuminant) {
    return illuminant.substr(0, illuminant.rfind(kMark));
}

}  // namespace specbake
