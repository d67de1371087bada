#include "solve/natural/measured_set.h"

#include "color/tables.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace specbake {
namespace {

constexpr std::array<std::string_view, 4> kMaterials = {"skin", "leaf", "wood", "ground"};

}  // namespace

std::span<const std::string_view> materialNames() {
    return kMaterials;
}

}  // namespace specbake

namespace specbake::internal {
namespace {

MeasuredSample sampleOf(const tables::ReflectanceTable& table) {
    MeasuredSample sample{std::string(table.name), {}, std::string(table.material)};
    for (std::size_t m = 0; m < sample.reflectance.size(); ++m) {
        sample.reflectance[m] = table.value[m] / tables::kReflectanceScale;
    }
    return sample;
}

std::vector<MeasuredSet> unpacked() {
    std::vector<MeasuredSet> sets;
    for (const tables::ReflectanceTable& table : tables::kReflectances) {
        if (sets.empty() || sets.back().name != table.set) {
            sets.push_back({std::string(table.set), {}});
        }
        sets.back().samples.push_back(sampleOf(table));
    }
    return sets;
}

}  // namespace

const std::vector<MeasuredSet>& builtInSets() {
    static const std::vector<MeasuredSet> sets = unpacked();
    return sets;
}

std::vector<MeasuredSet> builtInSetsWithout(std::span<const std::string_view> names) {
    std::vector<MeasuredSet> sets = builtInSets();
    std::erase_if(sets, [&](const MeasuredSet& set) {
        return std::ranges::find(names, set.name) != names.end();
    });
    return sets;
}

std::vector<MeasuredSample> samplesOfMaterial(const std::vector<MeasuredSet>& sets,
                                              std::string_view material) {
    std::vector<MeasuredSample> samples;
    for (const MeasuredSet& set : sets) {
        std::ranges::copy_if(set.samples, std::back_inserter(samples),
                             [&](const MeasuredSample& s) { return s.material == material; });
    }
    return samples;
}

std::vector<MeasuredSample> atKnots(std::vector<MeasuredSample> samples, const Wavelengths& knots) {
    if (knots == Wavelengths()) return samples;
    for (MeasuredSample& sample : samples) {
        const Spectrum measured = sample.reflectance;
        for (int m = 0; m < kBandCount; ++m) {
            sample.reflectance[std::size_t(m)] =
                valueAt(measured, Wavelengths(), knots.at(std::min(m, knots.count - 1)));
        }
    }
    return samples;
}

}  // namespace specbake::internal
