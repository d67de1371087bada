#include "commands.h"
#include "figures.h"
#include "measures.h"
#include "nature/judged.h"
#include "nature/rivals.h"
#include "tasks.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

namespace specbake::bench {

namespace {

std::vector<NamedSpectrum> spectraOf(const std::vector<MeasuredSample>& samples) {
    std::vector<NamedSpectrum> list;
    for (const MeasuredSample& s : samples) list.push_back({s.name, s.reflectance});
    return list;
}

std::vector<Light> lights(const Options& options) {
    std::vector<Light> list;
    for (const char* name : {"A", "D50", "F2", "F11"}) list.push_back(lightOf(Observer(name)));
    list.push_back(readLight("LED-B3", options.data + "/illuminant_led_b3.csv"));
    return list;
}

std::vector<Figure> figuresOf(const Judged& set, const Options& options,
                              const std::vector<Light>& lamps) {
    std::vector<Figure> figures;
    const std::vector<NamedSpectrum> samples = spectraOf(set.samples);
    for (const auto& method : rivalsFor(set, options)) {
        method->setUp();
        for (const Measure& m : measureNature(*method, samples, lamps)) {
            figures.push_back({set.name, method->name(), m.quantity, m.value, m.unit, {}, ""});
        }
    }
    return figures;
}

/// Shown as curves; of each the samples a quarter and three quarters down its list.
constexpr std::array<std::string_view, 4> kShown = {"skin, by subject", "leaf", "wood", "DuPont"};

void addSpectra(Figures& figures, const Judged& set, const Options& options) {
    const auto methods = rivalsFor(set, options);
    for (const auto& method : methods) method->setUp();
    for (const std::size_t i : {set.samples.size() / 4, set.samples.size() * 3 / 4}) {
        const MeasuredSample& sample = set.samples[i];
        const std::string label = set.name + ": " + sample.name;
        figures.addSpectrum(label, {"measured", ""}, sample.reflectance);
        for (const auto& method : methods) {
            const XYZ color = method->frame().observer.color(sample.reflectance);
            figures.addSpectrum(label, method->name(), method->reconstruct(color).spectrum);
        }
    }
}

void writeSpectra(const std::vector<Judged>& judged, const Options& options) {
    Figures figures("nature-spectra", options.commandLine("nature"));
    for (const Judged& set : judged) {
        if (std::ranges::find(kShown, set.name) != kShown.end()) addSpectra(figures, set, options);
    }
    figures.write(options.out);
}

/// Of those sets together that count, each counting once.
std::vector<Figure> meanOf(const std::vector<Judged>& judged,
                           const std::vector<std::vector<Figure>>& figures) {
    std::vector<Figure> mean;
    double count = 0;
    for (std::size_t j = 0; j < judged.size(); ++j) {
        if (!judged[j].counts) continue;
        ++count;
        if (mean.empty()) {
            mean = figures[j];
            continue;
        }
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i].value += figures[j][i].value;
    }
    for (Figure& figure : mean) {
        figure.set = "mean of the sets";
        figure.value /= count;
    }
    return mean;
}

/// A row of docs/nature.md for each method: mean and 95th percentile under each lamp, mean RMS.
void print(const std::vector<Figure>& figures, const std::vector<Light>& lamps) {
    const auto value = [&](const MethodName& method, const std::string& quantity) {
        return std::ranges::find_if(figures,
                                    [&](const Figure& f) {
                                        return f.method.full() == method.full() &&
                                               f.quantity == quantity;
                                    })
            ->value;
    };
    for (const Figure& first : figures) {
        if (first.quantity != "reflectance error mean RMS") continue;
        std::string row = fmt::format("| {} | {} |", first.set, first.method.family);
        for (const Light& lamp : lamps) {
            row += fmt::format(" {:.2f}, {:.1f} |",
                               value(first.method, "under " + lamp.name + " mean"),
                               value(first.method, "under " + lamp.name + " p95"));
        }
        fmt::print("{} {:.3f} |\n", row, first.value);
    }
}

}  // namespace

void runNature(const Options& options) {
    const std::vector<Light> lamps = lights(options);
    std::vector<Judged> judged = judgedSets(options);
    for (Judged& material : judgedMaterials()) judged.push_back(std::move(material));
    std::vector<Task<std::vector<Figure>>> tasks;
    for (const Judged& set : judged) {
        tasks.push_back(
            {set.name, [=, &options, &lamps] { return figuresOf(set, options, lamps); }});
    }
    Progress progress("nature", tasks.size());
    std::vector<std::vector<Figure>> sets = onAllCores(tasks, progress);
    sets.push_back(meanOf(judged, sets));
    Figures figures("nature", options.commandLine("nature"));
    for (const std::vector<Figure>& of : sets) {
        print(of, lamps);
        for (const Figure& figure : of) figures.add(figure);
    }
    figures.write(options.out);
    writeSpectra(judged, options);
}

}  // namespace specbake::bench
