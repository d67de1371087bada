#include "model_options.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/image/light_file.h>
#include <specbake/image/measured_file.h>
#include <specbake/image/observer_file.h>

#include <cmath>

namespace specbake::python {
namespace {

/// As near to even steps as numpy's arange and linspace come.
Wavelengths evenly(const std::vector<double>& nm) {
    if (nm.size() < 2) throw ArgumentError("a spectrum needs 4 bands at least");
    const double step = (nm.back() - nm.front()) / double(nm.size() - 1);
    const Wavelengths even{nm.front(), step, int(nm.size())};
    for (int band = 0; band < even.count; ++band) {
        if (!(std::abs(nm[std::size_t(band)] - even.at(band)) < 1e-6)) {
            throw ArgumentError("wavelengths of a model are evenly spaced");
        }
    }
    return parseWavelengths(wavelengthsText(even));
}

}  // namespace

Adaptation adaptationNamed(const std::string& name) {
    const std::optional<Adaptation> adaptation = adaptationFromName(name);
    if (!adaptation) throw ArgumentError("unknown adaptation '" + name + "'");
    return *adaptation;
}

Quadrature quadratureNamed(const std::string& name) {
    const std::optional<Quadrature> quadrature = quadratureFromName(name);
    if (!quadrature) throw ArgumentError("quadrature is 'bands' or 'fine', not '" + name + "'");
    return *quadrature;
}

std::string lightNamed(const std::string& name) {
    std::string reason;
    if (isIlluminant(name, &reason)) return name;
    if (!std::filesystem::exists(name)) throw ArgumentError(reason);
    return readLight(name);
}

std::string observerNamed(const std::string& name) {
    std::string reason;
    if (isObserver(name, &reason)) return name;
    if (!std::filesystem::exists(name)) throw ArgumentError(reason);
    return readObserver(name);
}

Wavelengths wavelengthsOf(const WavelengthWords& words) {
    const auto* text = std::get_if<std::string>(&words);
    return text != nullptr ? parseWavelengths(*text) : evenly(std::get<std::vector<double>>(words));
}

UpsamplerOptions modelOptions(const ModelWords& words) {
    UpsamplerOptions options;
    if (words.light) options.illuminant = lightNamed(*words.light);
    options.observer = observerNamed(words.observer);
    options.adapt = adaptationNamed(words.adapt);
    if (words.method) options.method = *words.method;
    const std::optional<Outside> rule = outsideFromName(words.outside);
    if (!rule) throw ArgumentError("unknown rule for colours outside: '" + words.outside + "'");
    options.outside = *rule;
    options.grid = words.grid;
    options.material = words.material;
    if (words.samples) options.samples = readMeasuredFile(words.samples->string()).samples;
    if (words.wavelengths) {
        options.bands = wavelengthsOf(*words.wavelengths);
        options.quadrature = Quadrature::fine;
    }
    if (words.quadrature) options.quadrature = quadratureNamed(*words.quadrature);
    return options;
}

}  // namespace specbake::python
