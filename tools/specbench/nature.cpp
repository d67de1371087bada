#include "colors/patches.h"
#include "commands.h"
#include "figures.h"
#include "measures.h"
#include "methods/max_entropy.h"
#include "methods/published/jakob2019.h"
#include "methods/published/mallett2019.h"
#include "methods/solver_method.h"
#include "solve/natural/natural.h"
#include "solve/shell.h"
#include "tasks.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

namespace specbake::bench {

using namespace internal;

namespace {

/// Measured reflectances to be rebuilt, and the sets that may vote on them.
struct Judged {
    std::string name;
    std::vector<NamedSpectrum> samples;
    std::vector<MeasuredSet> voters;
};

std::vector<NamedSpectrum> spectraOf(const MeasuredSet& set) {
    std::vector<NamedSpectrum> list;
    for (const MeasuredSample& s : set.samples) list.push_back({s.name, s.reflectance});
    return list;
}

/// All sets but this one. The two charts have patches in common, and leave together.
std::vector<MeasuredSet> without(const std::string& set) {
    if (set == "SG" || set == "ColorChecker") {
        return builtInSetsWithout(std::array<std::string_view, 2>{"SG", "ColorChecker"});
    }
    return builtInSetsWithout(std::array<std::string_view, 1>{set});
}

void removeMaterial(std::vector<MeasuredSet>& sets, std::string_view material) {
    for (MeasuredSet& set : sets) {
        std::erase_if(set.samples, [&](const MeasuredSample& s) { return s.material == material; });
    }
}

/// The built-in sets, each left out; skin without any skin; and the files that are named.
std::vector<Judged> judgedSets(const Options& options) {
    std::vector<Judged> list;
    for (const MeasuredSet& set : builtInSets()) {
        list.push_back({set.name, spectraOf(set), without(set.name)});
        if (set.name != "skin") continue;
        list.push_back({"skin, without skin", spectraOf(set), without(set.name)});
        removeMaterial(list.back().voters, "skin");
    }
    for (const Chart& chart : readCharts(options)) {
        if (chart.name == "colorchecker_24") continue;  // built in
        list.push_back({chart.name, chart.patches, builtInSets()});
    }
    return list;
}

std::vector<Light> lights(const Options& options) {
    std::vector<Light> list;
    for (const char* name : {"A", "D50", "F2", "F11"}) list.push_back(lightOf(Observer(name)));
    list.push_back(readLight("LED-B3", options.data + "/illuminant_led_b3.csv"));
    return list;
}

std::vector<std::unique_ptr<Method>> methodsFor(const Judged& set, const Options& options) {
    const Frame frame = sRGBFrame();
    const auto smooth = std::make_shared<const ShellSolver>(frame.observer);
    std::vector<std::unique_ptr<Method>> list;
    list.push_back(std::make_unique<SolverMethod>(MethodName{"smooth", ""}, frame, smooth));
    list.push_back(std::make_unique<SolverMethod>(
        MethodName{"natural", "set left out"}, frame,
        std::make_shared<const NaturalSolver>(frame.observer, smooth, set.voters)));
    list.push_back(std::make_unique<Jakob2019Direct>(frame));
    list.push_back(std::make_unique<MaxEntropy>(frame));
    list.push_back(std::make_unique<Mallett2019>(frame, options.data + "/mallett2019.csv"));
    return list;
}

std::vector<Figure> figuresOf(const Judged& set, const Options& options,
                              const std::vector<Light>& lamps) {
    std::vector<Figure> figures;
    for (const auto& method : methodsFor(set, options)) {
        method->setUp();
        for (const Measure& m : measureNature(*method, set.samples, lamps)) {
            figures.push_back({set.name, method->name(), m.quantity, m.value, m.unit, {}, ""});
        }
    }
    return figures;
}

/// Of all sets together, each counting once; "skin, without skin" is skin again, and does not.
std::vector<Figure> meanOf(const std::vector<std::vector<Figure>>& sets) {
    std::vector<Figure> mean;
    double count = 0;
    for (const std::vector<Figure>& of : sets) {
        if (of.front().set == "skin, without skin") continue;
        ++count;
        if (mean.empty()) {
            mean = of;
            continue;
        }
        for (std::size_t i = 0; i < of.size(); ++i) mean[i].value += of[i].value;
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
    std::vector<Task<std::vector<Figure>>> tasks;
    for (const Judged& set : judgedSets(options)) {
        tasks.push_back(
            {set.name, [=, &options, &lamps] { return figuresOf(set, options, lamps); }});
    }
    Progress progress("nature", tasks.size());
    std::vector<std::vector<Figure>> sets = onAllCores(tasks, progress);
    sets.push_back(meanOf(sets));
    Figures figures("nature", options.commandLine("nature"));
    for (const std::vector<Figure>& of : sets) {
        print(of, lamps);
        for (const Figure& figure : of) figures.add(figure);
    }
    figures.write(options.out);
}

}  // namespace specbake::bench
