#include "support/lookup_stand.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace specbake;
using specbake::testing::LookupStand;

namespace {

struct Bench : LookupStand {
    using LookupStand::LookupStand;

    struct Result {
        Spectrum spectrum{};
        TexelCensus census;
    };
    Result at(const std::array<float, 3>& color) {
        Result result;
        SpectrumLookup::Scratch scratch;
        const Mix mix = mixOf(color, scratch, result.census);
        for (std::size_t m = 0; m < kBandCount; ++m) {
            for (std::size_t k = 0; k < 4; ++k) {
                result.spectrum[m] +=
                    double(mix.weights[k]) * double(mix.values[k][kPreviewValues + m]);
            }
        }
        return result;
    }
    XYZ color(const std::array<float, 3>& c) const {
        return XYZ(RGB(double(c[0]), double(c[1]), double(c[2])) * matrix);
    }
};

double largest(const Imath::V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Float spectra and weights: 81 bands and 4 weights rounded to 2^-24, times weights w_m that sum
/// to the white, below 1.2; a transition blends twice.
constexpr double kFloatRounding = 1.2 * 12 * 0x1p-24;

}  // namespace

TEST_CASE("a looked-up spectrum has its texel's colour, in and across cut cells") {
    for (const char* name : {"lin_rec709", "lin_rec2020", "acescg"}) {
        Bench bench(name, 9);
        std::mt19937_64 random(17);
        std::uniform_real_distribution<float> uniform(0, 1);
        int direct = 0;
        int compared = 0;
        for (int trial = 0; trial < 3000; ++trial) {
            const std::array<float, 3> color = {uniform(random), uniform(random), uniform(random)};
            if (bench.solid.gauge(bench.color(color)) > 1) continue;
            const auto [spectrum, census] = bench.at(color);
            CHECK(largest(bench.observer.color(spectrum) - bench.color(color)) < kFloatRounding);
            CHECK(boundsViolation(spectrum) <= 4 * 0x1p-24);
            direct += int(census.of(Fate::solved).count);
            ++compared;
        }
        CAPTURE(name);
        CHECK(compared > 1000);
        // sRGB lies wholly in its solid; the wide spaces are cut by its boundary.
        CHECK((direct > 0) == (std::string(name) != "lin_rec709"));
    }
}

TEST_CASE("there is no step at the faces of the grid's cube, and colours beyond stay exact") {
    for (const char* name : {"lin_rec709", "lin_displayp3", "lin_rec2020"}) {
        CAPTURE(name);
        Bench bench(name, 9);
        std::mt19937_64 random(18);
        std::uniform_real_distribution<float> uniform(0, 1);
        double largestGap = 0;  // what there would be without the transition
        for (int trial = 0; trial < 1000; ++trial) {
            std::array<float, 3> inside = {uniform(random), uniform(random), uniform(random)};
            const std::size_t axis = std::size_t(trial % 3);
            const bool upper = trial % 2 == 0;
            inside[axis] = upper ? 1.0F : 0.0F;
            std::array<float, 3> beyond = inside;
            beyond[axis] = upper ? std::nextafter(1.0F, 2.0F) : -0x1p-30F;
            if (bench.solid.gauge(bench.color(beyond)) > 1) continue;
            const Spectrum onFace = bench.at(inside).spectrum;
            const Spectrum outside = bench.at(beyond).spectrum;
            // The steepest slope that was met (1340, Rec.2020 at the solid's boundary), doubled.
            CHECK(maxDifference(onFace, outside) <= 2 * 1340 * 0x1p-23);
            const Spectrum solved = bench.solver.solve(bench.color(beyond)).spectrum;
            largestGap = std::max(largestGap, maxDifference(onFace, solved));
            beyond[axis] += (upper ? 1.0F : -1.0F) * uniform(random) * 0.1F;
            if (bench.solid.gauge(bench.color(beyond)) > 1) continue;
            const Spectrum farther = bench.at(beyond).spectrum;
            CHECK(largest(bench.observer.color(farther) - bench.color(beyond)) <
                  3 * kFloatRounding);  // three spectra in a sum
            CHECK(boundsViolation(farther) <= 4 * 0x1p-24);
        }
        CHECK(largestGap > 0.01);
    }
}

TEST_CASE("outside colours count as moved, refused or not finite, and only these") {
    Bench nearest("lin_rec709");
    CHECK(nearest.at({0.5F, 0.5F, 0.5F}).census.of(Fate::moved).count == 0);
    CHECK(nearest.at({0, 0, 0}).census.of(Fate::moved).count == 0);
    CHECK(nearest.at({1, 1, 1}).census.of(Fate::moved).count == 0);
    const auto bright = nearest.at({2, 0.5F, 0.1F});
    CHECK(bright.census.of(Fate::moved).count == 1);
    CHECK(bright.census.largestMove() > 1);
    CHECK(nearest.at({std::nanf(""), 0, 0}).census.of(Fate::notFinite).count == 1);
    CHECK(nearest.at({INFINITY, 0, 0}).census.of(Fate::notFinite).count == 1);
    CHECK_FALSE(nearest.at({INFINITY, 0, 0}).census.complete());

    Bench refusing("lin_rec709", 17, Outside::error);
    CHECK(refusing.at({2, 0.5F, 0.1F}).census.of(Fate::refused).count == 1);
    CHECK(refusing.at({0.2F, 0.5F, 0.1F}).census.complete());
}

TEST_CASE("a repeated texel is counted each time, and cached texels are the same bits") {
    Bench bench("lin_rec709");
    const std::array<float, 3> color = {2, 0.5F, 0.1F};
    const std::vector<std::array<float, 3>> row(5, color);
    std::vector<Mix> mixes(5);
    SpectrumLookup::Scratch scratch;
    TexelCensus census;
    bench.lookup.locate(row, 100, mixes, scratch, census);
    CHECK(census.of(Fate::moved).count == 5);
    CHECK(*census.of(Fate::moved).first == 100);
    CHECK(bench.at(color).spectrum == bench.at(color).spectrum);
    CHECK(Bench("lin_rec709").at(color).spectrum == bench.at(color).spectrum);
}

TEST_CASE("without a grid every texel is the solver's own spectrum, as float") {
    Bench bench("lin_rec709", std::nullopt);
    const std::array<float, 3> color = {0.3F, 0.5F, 0.1F};
    const Spectrum solved = bench.solver.solve(bench.color(color)).spectrum;
    CHECK(maxDifference(bench.at(color).spectrum, solved) <= 0x1p-25);  // half a unit below 1
    CHECK(bench.lookup.nodesSolved() == 0);
}

TEST_CASE("censuses add up, and the first texel is the one of the least number") {
    TexelCensus first;
    TexelCensus second;
    second.meet(7, Fate::moved, 3);
    second.meet(8, Fate::moved, 2);
    first.add(second);
    CHECK(*first.of(Fate::moved).first == 7);
    CHECK(first.of(Fate::moved).count == 2);
    CHECK(first.largestMove() == 3);
    second.meet(9, Fate::failed, 0);
    second.meet(5, Fate::moved, 0);
    first.add(second);
    CHECK(*first.of(Fate::moved).first == 5);
    CHECK(first.of(Fate::moved).count == 5);
    CHECK_FALSE(first.complete());
}
