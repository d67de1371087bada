#include "nature/judged.h"

#include "colors/patches.h"

#include <specbake/core/measured_sample.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace specbake::bench {

using namespace internal;

namespace {

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

std::vector<MeasuredSample> samplesOf(const Chart& chart) {
    std::vector<MeasuredSample> samples;
    for (const NamedSpectrum& patch : chart.patches) {
        samples.push_back({patch.name, patch.spectrum, ""});
    }
    return samples;
}

Judged byMaterial(std::string name, std::string_view material,
                  std::vector<MeasuredSample> samples) {
    const std::size_t count = samples.size();
    return {.name = std::move(name),
            .samples = std::move(samples),
            .voters = builtInSets(),
            .counts = false,
            .material = std::string(material),
            .folds = count};
}

}  // namespace

std::vector<Judged> judgedSets(const Options& options) {
    std::vector<Judged> list;
    for (const MeasuredSet& set : builtInSets()) {
        list.push_back({.name = set.name, .samples = set.samples, .voters = without(set.name)});
        if (set.name != "skin") continue;
        list.push_back(list.back());
        list.back().name = "skin, without skin";
        list.back().counts = false;
        removeMaterial(list.back().voters, "skin");
    }
    for (const Chart& chart : readCharts(options)) {
        if (chart.name == "colorchecker_24") continue;  // built in
        list.push_back({.name = chart.name, .samples = samplesOf(chart), .voters = builtInSets()});
    }
    return list;
}

std::vector<Judged> judgedMaterials() {
    std::vector<Judged> list;
    for (const std::string_view material : materialNames()) {
        if (material != "skin") {
            list.push_back(byMaterial(std::string(material), material,
                                      samplesOfMaterial(builtInSets(), material)));
            continue;
        }
        const auto& sets = builtInSets();
        const auto skin =
            std::ranges::find_if(sets, [](const MeasuredSet& set) { return set.name == "skin"; });
        list.push_back(byMaterial("skin, by subject", material, skin->samples));
        list.push_back(byMaterial("skin, by another laboratory", material, skin->samples));
        list.back().folds = 1;
    }
    return list;
}

}  // namespace specbake::bench
