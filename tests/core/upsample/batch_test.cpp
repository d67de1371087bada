#include <specbake/core/upsampler.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace specbake;

namespace {

using Color = Upsampler::Color;

/// In the cube and a little beyond its faces.
std::vector<Color> someColors(std::size_t count, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> uniform(-0.02F, 1.02F);
    std::vector<Color> colors(count);
    for (Color& color : colors) color = {uniform(random), uniform(random), uniform(random)};
    return colors;
}

Upsampler model(const char* space, std::optional<int> nodes, Outside rule = Outside::nearest) {
    UpsamplerOptions options;
    options.grid = nodes;
    options.outside = rule;
    return Upsampler(*findColorSpace(space), options);
}

struct Sampled {
    std::vector<float> samples;
    ColorCensus census;
};

Sampled sampled(const Upsampler& upsampler, std::span<const Color> colors) {
    const SampleSelection wanted = SampleSelection::channels();
    Sampled result;
    result.samples.resize(colors.size() * kTexelSamples);
    Upsampler::Workspace workspace;
    const auto target = SampleTarget::interleaved(
        SampleType::float32, reinterpret_cast<std::byte*>(result.samples.data()), wanted);
    result.census = upsampler.sample(colors, wanted, target, workspace);
    return result;
}

void checkAgainstEachAlone(const char* space, std::optional<int> nodes, Outside rule) {
    CAPTURE(space);
    std::vector<Color> colors = someColors(2600, 18);  // more than are solved together
    colors[7] = {std::nanf(""), 0, 0};
    colors[8] = {3, -2, 1};
    colors[9] = colors[8];
    colors[2500] = colors[3];
    const Upsampler upsampler = model(space, nodes, rule);
    const Sampled together = sampled(upsampler, colors);
    const Upsampler another = model(space, nodes, rule);
    Sampled alone;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Sampled one = sampled(another, {&colors[i], 1});
        alone.samples.insert(alone.samples.end(), one.samples.begin(), one.samples.end());
        alone.census.add(one.census, i);
    }
    CHECK(std::memcmp(together.samples.data(), alone.samples.data(),
                      alone.samples.size() * sizeof(float)) == 0);
    using enum Fate;
    for (const Fate fate : {solved, moved, refused, notFinite, failed}) {
        CHECK(together.census.of(fate).count == alone.census.of(fate).count);
        CHECK(together.census.of(fate).first == alone.census.of(fate).first);
    }
    CHECK(together.census.largestMove() == alone.census.largestMove());
    CHECK(upsampler.nodesSolved() == another.nodesSolved());
}

}  // namespace

TEST_CASE("many colours at once have the samples and the fates that each has by itself") {
    for (const char* space : {"lin_rec709", "acescg", "xyz"}) {
        checkAgainstEachAlone(space, 9, Outside::nearest);
        checkAgainstEachAlone(space, 9, Outside::scale);
        checkAgainstEachAlone(space, {}, Outside::nearest);
        checkAgainstEachAlone(space, {}, Outside::error);
    }
}

TEST_CASE("noted nodes are those that are needed, and solved before they are") {
    const std::vector<Color> colors = someColors(500, 19);
    std::vector<Color> inCube;
    for (const Color& c : colors) {
        const auto [low, high] = std::minmax_element(c.begin(), c.end());
        if (*low >= 0 && *high <= 1) inCube.push_back(c);
    }
    const Upsampler noted = model("acescg", 9);
    const Upsampler asked = model("acescg", 9);
    const std::size_t waiting = noted.noteNodes(colors);
    CHECK(waiting > 64);
    CHECK(noted.noteNodes(colors) == waiting);
    noted.solveNotedNodes();
    CHECK(noted.noteNodes(colors) == 0);
    CHECK(noted.nodesSolved() == waiting);
    CHECK(sampled(noted, inCube).samples == sampled(asked, inCube).samples);
    CHECK(noted.nodesSolved() == waiting);
    CHECK(asked.nodesSolved() == waiting);
    CHECK(model("lin_rec709", {}).noteNodes(colors) == 0);
}
