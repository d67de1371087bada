#include "fit/natural_samples.h"

#include <specbake/core/error.h>

#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace specbake::bench {
namespace {

struct Source {
    const char* set;
    const char* file;
};

constexpr std::array kSources = {
    Source{"AMPAS", "refl_ampas_190.csv"},
    Source{"CES", "refl_ces_99.csv"},
    Source{"DuPont", "refl_dupont_120.csv"},
    Source{"objects", "refl_vrhel_objects_170.csv"},
    Source{"skin", "refl_skin_71.csv"},
    Source{"SG", "refl_colorchecker_sg_140.csv"},
    Source{"ColorChecker", "refl_colorchecker_24.csv"},
};

/// Words that the name of a material's sample begins or ends with.
struct Word {
    const char* word;
    const char* material;
};

constexpr std::array kWords = {
    Word{"skin -", "skin"}, Word{"leaf", "leaf"},    Word{"pine needles", "leaf"},
    Word{"grass", "leaf"},  Word{"cabbage", "leaf"}, Word{"lettuce", "leaf"},
    Word{"wood", "wood"},   Word{"bamboo", "wood"},  Word{"rocks", "ground"},
    Word{"soil", "ground"}, Word{"bark", "ground"},  Word{"asphalt", "ground"},
    Word{"sand", "ground"},
};

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

constexpr const char* kHeading =
    "# Measured reflectances that the method `natural` is made of, in ten-thousandths, 380-780 nm\n"
    "# every 5 nm. Sources and licences: NOTICE.md beside this file. Made again by ./dev fit.\n"
    "set,name,material";

void writeRow(std::ostream& out, const std::string& set, const NamedSpectrum& sample) {
    fmt::print(out, "{},{},{}", set, sample.name, materialOf(set, sample.name));
    for (const double value : sample.spectrum) fmt::print(out, ",{}", std::lround(value * 1e4));
    out << '\n';
}

}  // namespace

std::string materialOf(const std::string& set, const std::string& sample) {
    if (set == "skin") return "skin";
    if (set != "objects") return "";
    const std::string name = lowerCase(sample);
    for (const Word& word : kWords) {
        if (name.starts_with(word.word) || name.ends_with(word.word)) return word.material;
    }
    return "";
}

void fitNatural(const std::string& folder, const std::string& output) {
    std::ofstream out(output);
    out << kHeading;
    for (int m = 0; m < kBandCount; ++m) fmt::print(out, ",{}", wavelength(m));
    out << '\n';
    for (const Source& source : kSources) {
        for (const NamedSpectrum& sample : readReflectances(folder + '/' + source.file)) {
            if (boundsViolation(sample.spectrum) == 0) writeRow(out, source.set, sample);
        }
    }
    out.flush();
    if (!out) throw FileError(output, "cannot be written");
}

}  // namespace specbake::bench
