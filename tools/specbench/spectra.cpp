#include "commands.h"
#include "figures.h"
#include "methods/catalog.h"
#include "methods/csv.h"
#include "progress.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace specbake::bench {
namespace {

/// Twelve patches of the ColorChecker: the six saturated ones, skin, sky, foliage, and three more
/// whose spectra have a shape of their own.
constexpr std::array<std::string_view, 12> kPatches = {
    "dark skin", "blue sky", "foliage", "orange", "purple",  "yellow green",
    "blue",      "green",    "red",     "yellow", "magenta", "cyan"};

}  // namespace

void runSpectra(const Options& options) {
    Figures figures("spectra", options.commandLine("spectra"));
    const auto patches = readReflectances(options.data + "/colorchecker_24.csv");
    const Methods methods = oneOfEach(options.data);
    Progress progress("spectra", methods.size());
    for (const NamedSpectrum& patch : patches) {
        if (std::ranges::find(kPatches, patch.name) == kPatches.end()) continue;
        figures.addSpectrum(patch.name, {"measured", ""}, patch.spectrum);
    }
    for (const auto& method : methods) {
        progress.next(method->name().full());
        method->setUp();
        for (const NamedSpectrum& patch : patches) {
            if (std::ranges::find(kPatches, patch.name) == kPatches.end()) continue;
            const XYZ color = method->frame().observer.color(patch.spectrum);
            figures.addSpectrum(patch.name, method->name(), method->reconstruct(color).spectrum);
        }
    }
    figures.write(options.out);
}

}  // namespace specbake::bench
