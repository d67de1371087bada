#include "process.h"
#include "read_back.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace specbake::testing;

TEST_SUITE_BEGIN("material");

namespace {

constexpr int kWidth = 21;
constexpr int kHeight = 37;

/// Browns and greens, and a map of two materials with soft borders, holes, and shares above 1.
struct Scene {
    Scene() {
        std::vector<float> colors, shares;
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const float u = float(i % kWidth) / (kWidth - 1);
            const float v = float(i / kWidth) / (kHeight - 1);
            colors.insert(colors.end(), {0.1F + 0.3F * u, 0.1F + 0.1F * v, 0.05F});
            shares.insert(shares.end(), {std::max(0.0F, 1.5F * u - 0.3F), v * (1 - u), 0.5F});
        }
        shares[0] = NAN;
        const OIIO::ImageSpec spec(kWidth, kHeight, 3, OIIO::TypeDesc::FLOAT);
        writeImage(scratch.path("t.exr"), spec, colors);
        writeImage(scratch.path("map.exr"), spec, shares);
    }

    Outcome bake(const std::string& name, const std::vector<std::string>& more) const {
        std::vector<std::string> words{
            "bake", scratch.path("t.exr"), "-o", scratch.path(name), "--method", "natural"};
        words.insert(words.end(), more.begin(), more.end());
        return runTool(words);
    }
    ReadBack baked(const std::string& name, const std::vector<std::string>& more) const {
        REQUIRE(bake(name, more).exitCode == 0);
        return ReadBack(scratch.path(name));
    }
    std::string map() const { return scratch.path("map.exr"); }

    Scratch scratch;
};

/// The two shares of a texel, as the map has them: each from 0 to 1, both at most 1.
std::pair<float, float> sharesAt(const ReadBack& map, int x, int y) {
    const auto share = [&](const char* channel) {
        const float value = map.at(x, y, channel);
        return value > 0 ? std::min(value, 1.0F) : 0;
    };
    const float sum = std::max(1.0F, share("R") + share("G"));
    return {share("R") / sum, share("G") / sum};
}

}  // namespace

TEST_CASE("a map mixes what bakes of each material give, texel by texel") {
    const Scene scene;
    const ReadBack map(scene.map());
    const auto none = scene.baked("none.exr", {"-d", "float"});
    const auto skin = scene.baked("skin.exr", {"-d", "float", "--material", "skin"});
    const auto leaf = scene.baked("leaf.exr", {"-d", "float", "--material", "leaf"});
    const auto mixed = scene.baked(
        "m.exr", {"-d", "float", "--material", "skin,leaf", "--material-map", scene.map()});
    double worst = 0, moved = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto [w, v] = sharesAt(map, x, y);
            const auto a = none.bands(x, y), b = skin.bands(x, y), c = leaf.bands(x, y),
                       found = mixed.bands(x, y);
            for (std::size_t m = 0; m < found.size(); ++m) {
                const double expected = double(a[m]) + double(w) * double(b[m] - a[m]) +
                                        double(v) * double(c[m] - a[m]);
                worst = std::max(worst, std::abs(double(found[m]) - expected));
                moved = std::max(moved, std::abs(double(found[m] - a[m])));
            }
        }
    }
    CHECK(worst <= 8 * 0x1p-24);  // roundings of floats below 1
    CHECK(moved > 0.02);
    CHECK(mixed.spec.get_string_attribute("specbake:material") == "skin,leaf");
    CHECK(mixed.spec.get_string_attribute("specbake:materialMap") == "map.exr");
    const Outcome verified =
        runTool({"verify", scene.scratch.path("m.exr"), scene.scratch.path("t.exr")});
    CHECK(verified.exitCode == 0);
}

TEST_CASE("tiles, mip levels, fewer bits and threads mix alike") {
    const Scene scene;
    const std::vector<std::string> how{"--material", "wood,ground", "--material-map", scene.map()};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), how.begin(), how.end());
        return more;
    };
    const auto plain = scene.baked("a.exr", with({}));
    const auto tiled = scene.baked("b.exr", with({"--tile", "16", "16", "--mipmap"}));
    CHECK(plain.samples == tiled.samples);
    REQUIRE(scene.bake("c.exr", with({"-j", "1"})).exitCode == 0);
    CHECK(contentsOf(scene.scratch.path("a.exr")) == contentsOf(scene.scratch.path("c.exr")));
    const auto rough = scene.baked("d.exr", with({"--bits", "6"}));
    for (std::size_t i = 0; i < plain.samples.size(); ++i) {
        // Half a step of 6 bits, and half a step of 10.
        const float value = plain.samples[i];
        REQUIRE(std::abs(rough.samples[i] - value) <= value * (0x1p-7F + 0x1p-11F));
    }
}

TEST_CASE("a map that does not fit is refused, and leaves no file") {
    const Scene scene;
    const std::string grey = scene.scratch.path("grey.exr"), small = scene.scratch.path("s.exr");
    writeImage(grey, OIIO::ImageSpec(kWidth, kHeight, 1, OIIO::TypeDesc::FLOAT),
               std::vector<float>(kWidth * kHeight, 0.5F));
    writeImage(small, OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::FLOAT), std::vector<float>(12));
    const auto refused = [&](const std::string& materials, const std::string& map, int exitCode,
                             const std::string& words) {
        const Outcome bake = scene.bake("o.exr", {"--material", materials, "--material-map", map});
        CAPTURE(bake.err);
        CHECK(bake.exitCode == exitCode);
        CHECK(bake.err.find(words) != std::string::npos);
    };
    refused("skin", small, 1, "has the size of its texture, 21 x 37, not 2 x 2");
    refused("skin,leaf", grey, 1, "1 channels for 2 materials");
    refused("skin", scene.scratch.path("absent.exr"), 1, "absent.exr");
    refused("skin,wool", scene.map(), 2, "wool");
    refused("skin,leaf,wood,ground", scene.map(), 2, "at most 3 materials");
    CHECK(scene.bake("o.exr", {"--material-map", scene.map()}).exitCode == 2);
    CHECK(scene.bake("o.exr", {"--material", "skin,leaf"}).exitCode == 2);
    CHECK(scene.bake("map.exr", {"--material", "skin", "--material-map", scene.map()}).exitCode ==
          2);
    CHECK(scene.bake("o.exr", {"--material", "skin", "--material-map", grey}).exitCode == 0);
    const auto names = scene.scratch.names();
    CHECK(names == std::vector<std::string>{"grey.exr", "map.exr", "o.exr", "s.exr", "t.exr"});
}
