#include "solve/natural/natural.h"
#include "solve/samples/with_samples.h"
#include "solve/shell.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>
#include <specbake/core/upsampler.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::internal;

namespace {

std::vector<MeasuredSet> setsWithout(const Spectrum& reflectance) {
    std::vector<MeasuredSet> sets = builtInSets();
    for (MeasuredSet& set : sets) {
        std::erase_if(set.samples,
                      [&](const MeasuredSample& s) { return s.reflectance == reflectance; });
    }
    return sets;
}

UpsamplerOptions directly(const std::string& method) {
    UpsamplerOptions options;
    options.method = method;
    options.grid.reset();
    return options;
}

}  // namespace

TEST_CASE("skin with the material skin, by subject: at most 0.3 under A, where smooth has 2.5") {
    const Observer observer("D65"), lamp("A");
    const auto lab = [&](const Spectrum& s) { return labFromXYZ(lamp.color(s), lamp.white()); };
    const auto smooth = std::make_shared<const ShellSolver>(observer);
    double with = 0, without = 0, count = 0;
    const std::vector<MeasuredSample> subjects = samplesOfMaterial(builtInSets(), "skin");
    for (std::size_t i = 0; i < subjects.size(); i += 4) {
        const Spectrum& subject = subjects[i].reflectance;
        const auto sets = setsWithout(subject);
        const auto natural = std::make_shared<const NaturalSolver>(observer, smooth, sets);
        const auto solver = withMaterial(observer, natural, sets, "skin");
        const XYZ color = observer.color(subject);
        with += ciede2000(lab(solver->solve(color).spectrum), lab(subject));
        without += ciede2000(lab(smooth->solve(color).spectrum), lab(subject));
        ++count;
    }
    CHECK(count >= 18);
    CHECK(with / count <= 0.3);
    CHECK(without / count >= 2);
}

TEST_CASE("a material is heard about its own colours only: a red berry among leaves is natural") {
    const ColorSpace& space = *findColorSpace("lin_rec709");
    UpsamplerOptions leafy = directly("natural");
    leafy.material = "leaf";
    const Upsampler natural(space, directly("natural")), leaf(space, leafy);
    const auto apart = [&](const RGB& rgb) {
        return maxDifference(natural.solve(natural.xyz(rgb)).solution.spectrum,
                             leaf.solve(leaf.xyz(rgb)).solution.spectrum);
    };
    CHECK(apart({0.05, 0.1, 0.02}) > 0.02);
    CHECK(apart({0.5, 0.02, 0.03}) < 0.02);
    CHECK(apart({0.05, 0.1, 0.7}) < 0.005);
    CHECK(leaf.identity().find("material leaf") != std::string::npos);
    CHECK(leaf.notes().empty());
}

TEST_CASE("every material has samples, and no other word is one") {
    for (const std::string_view material : materialNames()) {
        CHECK(samplesOfMaterial(builtInSets(), material).size() >= 9);
    }
    UpsamplerOptions options;
    options.material = "wool";
    std::string reason;
    CHECK(!options.isValid(&reason));
    CHECK(reason == "unknown material 'wool'");
    CHECK_THROWS_AS(Upsampler(*findColorSpace("lin_rec709"), options), ArgumentError);
}

TEST_CASE("samples are part of the identity, by their values alone") {
    UpsamplerOptions options;
    options.samples = {{"a", constantSpectrum(0.25), ""}, {"b", constantSpectrum(0.5), ""}};
    UpsamplerOptions renamed = options, other = options;
    renamed.samples[0].name += "renamed";
    other.samples[1].reflectance[40] = 0.75;
    const ColorSpace& space = *findColorSpace("lin_rec709");
    const Upsampler first(space, options);
    CHECK(first.identity() == Upsampler(space, renamed).identity());
    CHECK(first.identity() != Upsampler(space, other).identity());
    CHECK(first.identity() != Upsampler(space, UpsamplerOptions()).identity());
    CHECK(first.samplesIdentity().starts_with("2 samples "));
    REQUIRE(first.notes().size() == 1);
    CHECK(first.notes()[0] ==
          "2 samples, each left out: mean CIEDE2000 0.00 under A; without samples 0.00");
    other.samples[1].reflectance[40] = 1.5;
    std::string reason;
    CHECK(!other.isValid(&reason));
    CHECK(reason.find("'b' is no reflectance") != std::string::npos);
    other.samples.resize(kMostSamples + 1);
    CHECK(!other.isValid(&reason));
}
