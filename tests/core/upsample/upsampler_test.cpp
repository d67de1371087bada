#include "solve/shell.h"

#include <specbake/core/error.h>
#include <specbake/core/methods.h>
#include <specbake/core/upsampler.h>
#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <set>

using namespace specbake;
using namespace specbake::internal;

namespace {

UpsamplerOptions options(std::optional<int> grid, Outside rule = Outside::nearest) {
    UpsamplerOptions o;
    o.method = "smooth";  // as the solver that answers are compared with
    o.grid = grid;
    o.outside = rule;
    return o;
}

/// A model in a space under its own white.
struct Bench {
    explicit Bench(const char* spaceName, std::optional<int> nodes = 17,
                   Outside rule = Outside::nearest)
        : upsampler(*findColorSpace(spaceName), options(nodes, rule)),
          observer(upsampler.observer()),
          solid(upsampler.solid()),
          solver(observer) {}

    struct Result {
        Spectrum spectrum{};
        ColorCensus census;
    };
    Result at(const Upsampler::Color& color) const {
        Result result;
        std::array<float, kBandCount> bands{};
        const SampleSelection wanted = SampleSelection::bands();
        Upsampler::Workspace workspace;
        const auto target = SampleTarget::interleaved(
            SampleType::float32, reinterpret_cast<std::byte*>(bands.data()), wanted);
        result.census = upsampler.sample({&color, 1}, wanted, target, workspace);
        std::copy(bands.begin(), bands.end(), result.spectrum.begin());
        return result;
    }

    XYZ color(const Upsampler::Color& c) const {
        return upsampler.xyz(RGB(double(c[0]), double(c[1]), double(c[2])));
    }

    Upsampler upsampler;
    Observer observer;
    Solid solid;
    ShellSolver solver;
};

/// Float spectra and weights: of a band, the node's value and the weights rounded to 2^-24, four
/// sums and the result too; a transition blends twice. Times weights w_m that sum to the white,
/// below 1.2.
constexpr double kFloatRounding = 1.2 * 16 * 0x1p-24;

std::vector<Upsampler::Color> someColors(std::size_t count, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> uniform(-0.02F, 1.02F);
    std::vector<Upsampler::Color> colors(count);
    for (auto& color : colors) color = {uniform(random), uniform(random), uniform(random)};
    return colors;
}

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
            CHECK(largestComponent(bench.observer.color(spectrum) - bench.color(color)) <
                  kFloatRounding);
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
            CHECK(largestComponent(bench.observer.color(farther) - bench.color(beyond)) <
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
    CHECK(nearest.at({INFINITY, 0, 0}).census.withoutSpectrum() == 1);

    Bench refusing("lin_rec709", 17, Outside::error);
    CHECK(refusing.at({2, 0.5F, 0.1F}).census.of(Fate::refused).count == 1);
    CHECK(refusing.at({0.2F, 0.5F, 0.1F}).census.withoutSpectrum() == 0);
}

TEST_CASE("a repeated colour is counted each time, and known ones are the same bits") {
    Bench bench("lin_rec709");
    const Upsampler::Color color = {2, 0.5F, 0.1F};
    const std::vector<Upsampler::Color> row(5, color);
    std::vector<float> samples(5 * kTexelSamples);
    const SampleSelection channels = SampleSelection::channels();
    Upsampler::Workspace workspace;
    const auto target = SampleTarget::planar(
        SampleType::float32, reinterpret_cast<std::byte*>(samples.data()), 5 * sizeof(float));
    const ColorCensus census = bench.upsampler.sample(row, channels, target, workspace);
    CHECK(census.of(Fate::moved).count == 5);
    CHECK(*census.of(Fate::moved).first == 0);
    CHECK(bench.at(color).spectrum == bench.at(color).spectrum);
    CHECK(Bench("lin_rec709").at(color).spectrum == bench.at(color).spectrum);
}

TEST_CASE("without a grid every texel is the solver's own spectrum, as float") {
    Bench bench("lin_rec709", std::nullopt);
    const std::array<float, 3> color = {0.3F, 0.5F, 0.1F};
    const Spectrum solved = bench.solver.solve(bench.color(color)).spectrum;
    CHECK(maxDifference(bench.at(color).spectrum, solved) <= 0x1p-25);  // half a unit below 1
    CHECK(bench.upsampler.nodesSolved() == 0);
}

TEST_CASE("one colour is solved by itself, whatever the grid") {
    for (const std::optional<int> grid : {std::optional(3), std::optional<int>()}) {
        const Bench bench("acescg", grid);
        const XYZ asked = bench.color({0.3F, 0.5F, 0.1F});
        const ColorAnswer answer = bench.upsampler.solve(asked);
        CHECK(answer.solution.solved());
        CHECK_FALSE(answer.outside);
        CHECK(answer.gauge == bench.solid.gauge(asked));
        CHECK(answer.solution.spectrum == bench.solver.solve(asked).spectrum);
    }
    const ColorAnswer refused =
        Bench("lin_rec709", 17, Outside::error).upsampler.solve(XYZ(2, 1, 1));
    CHECK(refused.solution.report.status == SolveReport::Status::outside);
}

TEST_CASE("planes, colours side by side, and single bands are the same samples") {
    const Bench bench("lin_rec2020", 9);
    const auto colors = someColors(700, 5);  // several blocks of the kernel, and a rest
    const SampleSelection channels = SampleSelection::channels();
    std::vector<float> planes(colors.size() * kTexelSamples);
    Upsampler::Workspace workspace;
    const auto planar =
        SampleTarget::planar(SampleType::float32, reinterpret_cast<std::byte*>(planes.data()),
                             colors.size() * sizeof(float));
    REQUIRE(bench.upsampler.sample(colors, channels, planar, workspace).withoutSpectrum() == 0);
    const std::vector<float> together = bench.upsampler.sample(colors, channels);
    const std::vector<float> bands = bench.upsampler.sample(colors, SampleSelection::bands());
    const std::array nm = {780.0, 380.0, 555.0};
    const std::vector<float> some = bench.upsampler.sample(colors, SampleSelection::at(nm));
    std::size_t differences = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const auto plane = [&](std::size_t p) { return planes[p * colors.size() + i]; };
        for (std::size_t p = 0; p < kTexelSamples; ++p) {
            differences += together[i * kTexelSamples + p] != plane(p);
        }
        for (std::size_t m = 0; m < kBandCount; ++m) {
            differences += bands[i * kBandCount + m] != plane(kPreviewSamples + m);
        }
        differences += some[3 * i] != plane(kTexelSamples - 1);
        differences += some[3 * i + 1] != plane(kPreviewSamples);
        differences += some[3 * i + 2] != plane(kPreviewSamples + (555 - 380) / 5);
    }
    CHECK(differences == 0);
}

TEST_CASE("halves are the floats rounded, in planes and side by side") {
    const Bench bench("lin_rec709");
    const auto colors = someColors(100, 6);
    const SampleSelection channels = SampleSelection::channels();
    const std::vector<float> floats = bench.upsampler.sample(colors, channels);
    std::vector<std::byte> expected(floats.size() * 2);
    storeSamples(floats, SampleType::half, expected.data());
    std::vector<std::byte> halves(expected.size());
    Upsampler::Workspace workspace;
    const auto target = SampleTarget::interleaved(SampleType::half, halves.data(), channels);
    REQUIRE(bench.upsampler.sample(colors, channels, target, workspace).withoutSpectrum() == 0);
    CHECK(halves == expected);
    std::vector<std::byte> planes(expected.size());
    const auto planar = SampleTarget::planar(SampleType::half, planes.data(), 2 * colors.size());
    REQUIRE(bench.upsampler.sample(colors, channels, planar, workspace).withoutSpectrum() == 0);
    std::size_t differences = 0;
    for (std::size_t i = 0; i < floats.size(); ++i) {
        const std::size_t plane = (i % kTexelSamples) * colors.size() + i / kTexelSamples;
        differences += std::memcmp(&planes[2 * plane], &halves[2 * i], 2) != 0;
    }
    CHECK(differences == 0);
}

TEST_CASE("between bands reflectance is linear, and beyond the ends it is theirs") {
    const Bench bench("lin_rec709");
    const Upsampler::Color color = {0.7F, 0.2F, 0.05F};
    const std::array nm = {300.0, 380.0, 381.0, 382.5, 384.0, 385.0, 779.0, 780.0, 830.0};
    const std::vector<float> s = bench.upsampler.sample({&color, 1}, SampleSelection::at(nm));
    CHECK(s[0] == s[1]);
    CHECK(s[8] == s[7]);
    // Three roundings of numbers below 1, each at most 2^-25.
    const auto near = [](float a, double b) { return std::abs(double(a) - b) <= 4 * 0x1p-25; };
    CHECK(near(s[2], 0.8 * double(s[1]) + 0.2 * double(s[5])));
    CHECK(near(s[3], 0.5 * double(s[1]) + 0.5 * double(s[5])));
    CHECK(near(s[4], 0.2 * double(s[1]) + 0.8 * double(s[5])));
    CHECK_THROWS_AS(SampleSelection::at(std::array{double(NAN)}), ArgumentError);
}

TEST_CASE("all nodes can be solved beforehand, and nothing changes by that") {
    const Bench later("acescg", 5);
    const Bench before("acescg", 5);
    before.upsampler.solveNodes();
    CHECK(before.upsampler.nodesSolved() == 125);
    const auto colors = someColors(300, 7);
    CHECK(before.upsampler.sample(colors, SampleSelection::bands()) ==
          later.upsampler.sample(colors, SampleSelection::bands()));
}

TEST_CASE("every method makes a model, exact and within [0, 1]") {
    for (const Method& method : methods()) {
        CAPTURE(method.name);
        UpsamplerOptions o;
        o.method = method.name;
        const Upsampler upsampler(*findColorSpace("lin_rec709"), o);
        const Upsampler::Color color = {0.8F, 0.1F, 0.3F};
        const std::vector<float> bands = upsampler.sample({&color, 1}, SampleSelection::bands());
        Spectrum spectrum;
        std::copy(bands.begin(), bands.end(), spectrum.begin());
        const RGB rgb{double(color[0]), double(color[1]), double(color[2])};
        CHECK(largestComponent(upsampler.observer().color(spectrum) - upsampler.xyz(rgb)) <
              kFloatRounding);
        CHECK(boundsViolation(spectrum) == 0);
    }
}

TEST_CASE("options that cannot be say why, and are refused") {
    std::string reason = "untouched";
    CHECK(UpsamplerOptions().isValid(&reason));
    CHECK(reason.empty());
    const auto refused = [&reason](auto change) {
        UpsamplerOptions o;
        change(o);
        CHECK_FALSE(o.isValid(&reason));
        CHECK_THROWS_WITH_AS(Upsampler(*findColorSpace("xyz"), o), reason.c_str(), ArgumentError);
        return reason;
    };
    CHECK(refused([](auto& o) { o.grid = 1; }) == "a grid has 2 to 129 nodes an axis, not 1");
    CHECK(refused([](auto& o) { o.grid = 130; }) == "a grid has 2 to 129 nodes an axis, not 130");
    CHECK(refused([](auto& o) { o.method = "rough"; }) == "unknown method 'rough'");
    CHECK(refused([](auto& o) { o.illuminant = "F99"; }) ==
          "unknown illuminant 'F99'; did you mean 'F9'?");
}

TEST_CASE("a model is told from every other by its identity") {
    const ColorSpace& rec709 = *findColorSpace("lin_rec709");
    UpsamplerOptions lit, coarse, direct, descending, scaling;
    lit.illuminant = "A";
    coarse.grid = 5;
    direct.grid = std::nullopt;
    descending.method = "descent";
    scaling.outside = Outside::scale;
    ColorSpace other = rec709;
    other.primaries->blue.y += 1e-9;
    std::set<std::string> identities = {Upsampler(other).identity(),
                                        Upsampler(*findColorSpace("xyz")).identity()};
    for (const auto& o : {UpsamplerOptions(), lit, coarse, direct, descending, scaling}) {
        identities.insert(Upsampler(rec709, o).identity());
    }
    CHECK(identities.size() == 8);
    CHECK(Upsampler(rec709).identity() == Upsampler(rec709).identity());
}

TEST_CASE("a colour without a spectrum is named where no census is given") {
    const Upsampler refusing(*findColorSpace("lin_rec709"), options(17, Outside::error));
    const std::vector<Upsampler::Color> colors = {{0.5F, 0.5F, 0.5F}, {2, 0.5F, 0.1F}};
    CHECK_THROWS_WITH_AS(refusing.sample(colors, SampleSelection::bands()),
                         "colour 1 has no spectrum", ArgumentError);
}

TEST_CASE("censuses add up, and the first texel is the one of the least number") {
    ColorCensus first;
    ColorCensus second;
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
    CHECK(first.withoutSpectrum() == 1);
    first.add(second, 100);
    CHECK(*first.of(Fate::moved).first == 5);
    ColorCensus shifted;
    shifted.add(second, 100);
    CHECK(*shifted.of(Fate::moved).first == 105);
}
