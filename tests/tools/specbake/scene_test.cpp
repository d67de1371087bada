#include "process.h"
#include "read_back.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

using namespace specbake::testing;
using nlohmann::json;

namespace {

/// What a bake says of itself, and where its file lies.
struct Baked {
    std::string path;
    json stats;
};

Baked bake(const Scratch& scratch, const std::string& name, const std::string& image,
           std::vector<std::string> options) {
    const std::string path = scratch.path(name + ".exr");
    const std::string stats = scratch.path(name + ".json");
    std::vector<std::string> arguments = {"bake",    "-q", testImage(image), "-o", path,
                                          "--stats", stats};
    arguments.insert(arguments.end(), options.begin(), options.end());
    REQUIRE(runTool(arguments).exitCode == 0);
    return {path, json::parse(contentsOf(stats))};
}

double largestDifference(const Baked& baked, const std::string& image) {
    const Outcome outcome =
        runTool({"verify", "--json", "--max-de", "100", baked.path, testImage(image)});
    REQUIRE(outcome.exitCode == 0);
    return json::parse(outcome.out)["de2000"]["max"];
}

/// RMS over bands and texels.
double deviation(const std::string& a, const std::string& b) {
    const ReadBack first(a);
    const ReadBack second(b);
    double sum = 0;
    std::size_t count = 0;
    for (int y = 0; y < first.spec.height; ++y) {
        for (int x = 0; x < first.spec.width; ++x) {
            const auto s = first.bands(x, y);
            const auto t = second.bands(x, y);
            for (std::size_t m = 0; m < s.size(); ++m) {
                sum += (double(s[m]) - double(t[m])) * (double(s[m]) - double(t[m]));
            }
            count += s.size();
        }
    }
    return std::sqrt(sum / double(count));
}

}  // namespace

TEST_SUITE_BEGIN("scene");

TEST_CASE("--max-de takes the fewest bits that keep it, and fewer would not") {
    const Scratch scratch;
    for (const char* image : {"17x33.png", "rgb_float.exr", "grey16.png"}) {
        for (const double limit : {1.0, 0.3, 0.1, 0.05}) {
            CAPTURE(image);
            CAPTURE(limit);
            const Baked chosen =
                bake(scratch, "chosen", image, {"--max-de", std::to_string(limit)});
            const int bits = chosen.stats["bits"];
            // verify compares with the texel itself, the limit with its spectrum in floats.
            constexpr double floats = 1e-3;
            CHECK(largestDifference(chosen, image) <= limit + floats);
            if (bits == 4) continue;
            const Baked fewer = bake(scratch, "fewer", image, {"--bits", std::to_string(bits - 1)});
            CHECK(largestDifference(fewer, image) > limit - floats);
        }
    }
}

TEST_CASE("fewer bits make smaller files, whose samples stay in [0, 1]") {
    const Scratch scratch;
    std::uintmax_t larger = UINTMAX_MAX;
    for (const char* bits : {"10", "8", "6", "4"}) {
        const Baked baked = bake(scratch, "b", "demo.png", {"--bits", bits});
        const auto size = std::filesystem::file_size(baked.path);
        CHECK(size < larger);
        larger = size;
        const Outcome outcome =
            runTool({"verify", "--json", "--max-de", "100", baked.path, testImage("demo.png")});
        CHECK(json::parse(outcome.out)["out_of_range"] == 0);
    }
}

TEST_CASE("--max-deviation takes the coarsest grid that keeps it, on every texel") {
    const Scratch scratch;
    // grey16.png repeats colours, unequally.
    for (const char* image : {"17x33.png", "rgb_float.exr", "grey16.png"}) {
        CAPTURE(image);
        const Baked direct = bake(scratch, "direct", image, {"--per-texel", "-d", "float"});
        int previous = 0;
        for (const double limit : {0.01, 0.003, 0.001, 0.0003}) {
            CAPTURE(limit);
            const Baked chosen = bake(scratch, "chosen", image,
                                      {"--max-deviation", std::to_string(limit), "-d", "float"});
            const int nodes = chosen.stats["grid"];
            CHECK(nodes >= previous);
            previous = nodes;
            // What it says is what the files say, but for the rounding of floats.
            const double measured = deviation(chosen.path, direct.path);
            CHECK(measured <= limit);
            CHECK(measured == doctest::Approx(double(chosen.stats["deviation"])).epsilon(1e-4));
            CHECK(double(chosen.stats["deviation_largest"]) >= measured);
            CHECK(chosen.stats["deviation_of_all"] == true);
        }
        CHECK(previous >= 3);
    }
}

TEST_CASE("a limit that nothing keeps is refused, with the reason") {
    const Scratch scratch;
    const Outcome bits = runTool({"bake", "-q", testImage("17x33.png"), "-o", scratch.path("o.exr"),
                                  "--max-de", "0.000001"});
    CHECK(bits.exitCode == 1);
    CHECK(linesOf(bits.err).size() == 1);
    const Outcome grid = runTool({"bake", "-q", testImage("17x33.png"), "-o", scratch.path("o.exr"),
                                  "--max-deviation", "0.0000000001"});
    CHECK(grid.exitCode == 1);
    CHECK(linesOf(grid.err).size() == 1);
    CHECK(scratch.names().empty());
}

TEST_SUITE_END();
