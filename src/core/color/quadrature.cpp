#include "color/matching.h"
#include "color/named_light.h"
#include "color/names.h"
#include "color/tables.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/core/quadrature.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace specbake {

using namespace internal;

namespace {

/// CIE 15: the Planckian radiator of illuminant A, with its c2 = 1.435e7 nm K and T = 2848 K.
double powerOfA(double nm) {
    const auto planck = [](double at) { return std::expm1(1.435e7 / (2848 * at)); };
    return 100 * std::pow(560 / nm, 5) * planck(560) / planck(nm);
}

/// 360 to 830 nm every 5 nm.
using FinePower = std::array<double, 95>;

/// What the CIE does not give repeats the nearest.
FinePower finePower(const NamedLight& light) {
    FinePower all;
    std::fill_n(all.begin(), 4, light.power.front());
    std::copy(light.power.begin(), light.power.end(), all.begin() + 4);
    std::fill(all.begin() + 85, all.end(), light.power.back());
    for (const auto& ends : tables::kIlluminantEnds) {
        if (ends.name != light.name) continue;
        for (std::size_t i = 0; i < 14; ++i) {
            const double power = i < 4 ? ends.below[i] : ends.above[i - 4];
            if (!std::isnan(power)) all[i < 4 ? i : i + 81] = power;
        }
    }
    return all;
}

/// The 5 nm tables, linear between as CIE 15 asks for the daylights.
double tabulatedPower(const FinePower& table, int nm) {
    const int row = (nm - kFinestFirst) / kWavelengthStep;
    const int rest = (nm - kFinestFirst) % kWavelengthStep;
    const double below = table[std::size_t(row)];
    if (rest == 0) return below;
    return below + (table[std::size_t(row) + 1] - below) * rest / kWavelengthStep;
}

/// What the bands give to a wavelength: band `first` and the next, by linear interpolation.
struct Share {
    std::size_t first = 0;
    double ofNext = 0;
};

Share shareAt(std::span<const double> bands, double nm) {
    const auto above = std::upper_bound(bands.begin(), bands.end(), nm);
    if (above == bands.begin()) return {};
    const auto first = std::size_t(above - bands.begin()) - 1;
    if (above == bands.end()) return {first, 0};
    return {first, (nm - bands[first]) / (bands[first + 1] - bands[first])};
}

/// Reads a number of `text` up to `end`; nothing if there is anything else.
std::optional<double> number(const char* text, const char* end) {
    double value = 0;
    const auto read = std::from_chars(text, end, value);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return {};
    return value;
}

}  // namespace

std::string_view quadratureName(Quadrature quadrature) {
    return quadrature == Quadrature::bands ? "bands" : "fine";
}

std::optional<Quadrature> quadratureFromName(std::string_view name) {
    for (const Quadrature quadrature : kQuadratures) {
        if (quadratureName(quadrature) == name) return quadrature;
    }
    return {};
}

std::string_view quadratureText(Quadrature quadrature) {
    return quadrature == Quadrature::bands
               ? "sum over the bands"
               : "every 1 nm from 360 to 830 nm, linear between the bands, their ends repeated";
}

std::optional<Quadrature> quadratureFromText(std::string_view text) {
    for (const Quadrature quadrature : kQuadratures) {
        if (quadratureText(quadrature) == text) return quadrature;
    }
    return {};
}

std::vector<Imath::V3d> fineWeights(std::string_view illuminant,
                                    std::span<const double> wavelengths,
                                    std::string_view observer) {
    const NamedLight light = lightNamed(illuminant);
    const auto matching = matchingNamed(observer);
    const bool isA = light.name == "A";
    const FinePower table = finePower(light);
    std::vector<Imath::V3d> weights(wavelengths.size(), Imath::V3d(0.0));
    double luminance = 0;
    for (int nm = kFinestFirst; nm <= kFinestLast; ++nm) {
        const auto& [x, y, z] = matching->fine[std::size_t(nm - kFinestFirst)];
        const Imath::V3d lit =
            Imath::V3d(x, y, z) * (isA ? powerOfA(nm) : tabulatedPower(table, nm));
        const auto [first, ofNext] = shareAt(wavelengths, nm);
        weights[first] += lit * (1 - ofNext);
        if (ofNext > 0) weights[first + 1] += lit * ofNext;
        luminance += lit.y;
    }
    for (Imath::V3d& weight : weights) weight /= luminance;
    return weights;
}

std::string wavelengthsProblem(const Wavelengths& w) {
    if (!(w.step >= 1)) return "wavelengths go up by steps of 1 nm at least";
    if (!(w.first >= kFinestFirst && w.last() <= kFinestLast)) {
        return "wavelengths lie within " + std::to_string(kFinestFirst) + " to " +
               std::to_string(kFinestLast) + " nm: beyond, nothing is seen";
    }
    if (w.count < 4) return "a spectrum needs 4 bands at least";
    return {};
}

Wavelengths parseWavelengths(const std::string& text) {
    const auto wrong = [&](const std::string& why) {
        return ArgumentError("wavelengths '" + text + "': " + why);
    };
    const auto firstColon = text.find(':');
    const auto secondColon = text.find(':', firstColon + 1);
    if (firstColon == std::string::npos || secondColon == std::string::npos) {
        throw wrong("START:STOP:STEP in nm is wanted, such as 400:700:10");
    }
    const char* const begin = text.data();
    const auto start = number(begin, begin + firstColon);
    const auto stop = number(begin + firstColon + 1, begin + secondColon);
    const auto step = number(begin + secondColon + 1, begin + text.size());
    if (!start || !stop || !step) throw wrong("three numbers are wanted, such as 400:700:10");
    if (!(*step > 0 && *stop > *start)) throw wrong("they go up from START to STOP");
    const double steps = (*stop - *start) / *step;
    if (std::abs(steps - std::round(steps)) > 1e-6) {
        throw wrong("STOP is not a whole number of steps from START");
    }
    if (steps > kFinestLast) throw wrong("steps of 1 nm at least are wanted");
    const Wavelengths result{*start, *step, int(std::lround(steps)) + 1};
    const std::string problem = wavelengthsProblem(result);
    if (!problem.empty()) throw wrong(problem);
    return result;
}

std::string wavelengthsText(const Wavelengths& w) {
    return decimal(w.first) + ':' + decimal(w.last()) + ':' + decimal(w.step);
}

std::vector<double> listed(const Wavelengths& wavelengths) {
    std::vector<double> list;
    for (int band = 0; band < wavelengths.count; ++band) list.push_back(wavelengths.at(band));
    return list;
}

}  // namespace specbake
