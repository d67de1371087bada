#include "nature/printed_color.h"
#include "process.h"
#include "read_back.h"
#include "support/csv.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using namespace specbake::testing;
using nlohmann::json;

TEST_SUITE_BEGIN("samples");

namespace {

const std::string kChart = SPECBAKE_SOURCE_DIR "/data/colorchecker_24.csv";

std::vector<std::string> colorUnderD65(const std::vector<double>& reflectance) {
    std::vector<std::string> words{"--xyz"};
    for (const double value : colorUnder("D65", reflectance)) {
        std::string digits(32, '\0');
        digits.resize(std::size_t(std::snprintf(digits.data(), 32, "%.17g", value)));
        words.push_back(digits);
    }
    return words;
}

std::vector<double> reflectanceOf(const std::vector<std::string>& row) {
    std::vector<double> values;
    for (std::size_t m = 1; m < row.size(); ++m) values.push_back(std::stod(row[m]));
    return values;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0;
    for (std::size_t m = 0; m < a.size(); ++m) largest = std::max(largest, std::abs(a[m] - b[m]));
    return largest;
}

}  // namespace

TEST_CASE("solve gives the sample at its colour, and says how good the samples are") {
    const auto patches = readCsv("data/colorchecker_24.csv");
    for (const std::size_t patch : {0U, 7U, 14U}) {
        const auto expected = reflectanceOf(patches[patch]);
        std::vector<std::string> words{"solve", "--json",    "--illuminant",
                                       "D65",   "--samples", kChart};
        for (const std::string& word : colorUnderD65(expected)) words.push_back(word);
        const Outcome solved = runTool(words);
        REQUIRE(solved.exitCode == 0);
        const auto found = json::parse(solved.out)["reflectance"].get<std::vector<double>>();
        CHECK(largestDifference(found, expected) <= 1e-9);
        CHECK(solved.err.find("24 samples, each left out: mean CIEDE2000") != std::string::npos);
    }
}

TEST_CASE("a bake has the sample at its texel, per texel and through the grid, and says so") {
    const Scratch scratch;
    const auto expected = reflectanceOf(readCsv("data/colorchecker_24.csv")[2]);
    const auto words = colorUnderD65(expected);
    std::vector<float> texel;
    for (std::size_t c = 1; c < 4; ++c) texel.push_back(std::stof(words[c]));
    writeImage(scratch.path("t.exr"), OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::FLOAT), texel);
    const auto bake = [&](const std::string& name, const std::string& way) {
        return runTool({"bake", scratch.path("t.exr"), "-o", scratch.path(name), "--space", "xyz",
                        "--illuminant", "D65", "-d", "float", way, "--samples", kChart});
    };
    const auto bandsOf = [&](const std::string& name) {
        const auto bands = ReadBack(scratch.path(name)).bands(0, 0);
        return std::vector<double>(bands.begin(), bands.end());
    };
    const Outcome direct = bake("direct.exr", "--per-texel");
    REQUIRE(direct.exitCode == 0);
    // Floats of the texel, 6e-8, times the steepest slope about a sample, below 100.
    CHECK(largestDifference(bandsOf("direct.exr"), expected) <= 1e-5);
    CHECK(direct.err.find("24 samples, each left out") != std::string::npos);
    REQUIRE(bake("grid.exr", "--grid=33").exitCode == 0);
    // The grid's nodes are some way off, and so are their spectra; still nearer than without.
    const double throughGrid = largestDifference(bandsOf("grid.exr"), expected);
    REQUIRE(runTool({"bake", scratch.path("t.exr"), "-o", scratch.path("w.exr"), "--space", "xyz",
                     "--illuminant", "D65", "--method", "natural"})
                .exitCode == 0);
    CHECK(throughGrid < 0.7 * largestDifference(bandsOf("w.exr"), expected));
    const auto spec = ReadBack(scratch.path("direct.exr")).spec;
    CHECK(spec.get_string_attribute("specbake:samples").find("24 samples ") == 0);
    CHECK(spec.get_string_attribute("specbake:method") == "natural");
    CHECK(runTool({"verify", scratch.path("grid.exr"), scratch.path("t.exr")}).exitCode == 0);
}

TEST_CASE("a table of samples names them in its identity; other samples are another table") {
    const Scratch scratch;
    const auto table = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> words{"table", "-o", scratch.path(name), "--grid", "3"};
        words.insert(words.end(), more.begin(), more.end());
        REQUIRE(runTool(words).exitCode == 0);
        return contentsOf(scratch.path(name));
    };
    const std::string with = table("a.spectab", {"--samples", kChart});
    CHECK(with.find("natural; 24 samples ") != std::string::npos);
    CHECK(with != table("b.spectab", {"--method", "natural"}));
    std::ofstream(scratch.path("s.csv")) << "nm,one\n380,0.1\n780,0.4\n";
    const std::string one = table("c.spectab", {"--samples", scratch.path("s.csv")});
    CHECK(one.find("; 1 samples ") != std::string::npos);
    const std::string onSmooth =
        table("d.spectab", {"--samples", scratch.path("s.csv"), "--method", "smooth"});
    CHECK(onSmooth.find("smooth; 1 samples ") != std::string::npos);
}

TEST_CASE("samples that are none are refused by name, and no file remains") {
    const Scratch scratch;
    std::ofstream(scratch.path("bad.csv")) << "name,380,780\na,0.1,x\n";
    for (const std::string& samples : {scratch.path("bad.csv"), scratch.path("absent.csv")}) {
        const Outcome bake = runTool(
            {"bake", testImage("demo.png"), "-o", scratch.path("o.exr"), "--samples", samples});
        CHECK(bake.exitCode == 1);
        CHECK(bake.err.find(samples) != std::string::npos);
        CHECK(runTool({"solve", "--rgb", ".1", ".2", ".3", "--samples", samples}).exitCode == 1);
    }
    CHECK(scratch.names() == std::vector<std::string>{"bad.csv"});
}
