#include "nature/printed_color.h"
#include "process.h"
#include "read_back.h"
#include "support/csv.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace specbake::testing;

TEST_SUITE_BEGIN("second");

namespace {

/// The 24 patches of a chart as textures of XYZ under D65 and under A: 6 by 4 texels.
struct Chart {
    Chart() {
        for (const auto& row : readCsv("data/colorchecker_24.csv")) {
            std::vector<double>& patch = patches.emplace_back();
            for (std::size_t m = 1; m < row.size(); ++m) patch.push_back(std::stod(row[m]));
        }
        write("d65.exr", "D65", 6);
        write("a.exr", "A", 6);
    }

    void write(const std::string& name, const std::string& light, int width) const {
        std::vector<float> texels;
        for (const std::vector<double>& patch : patches) {
            for (const double value : colorUnder(light, patch)) texels.push_back(float(value));
        }
        writeImage(scratch.path(name), OIIO::ImageSpec(width, 24 / width, 3, OIIO::TypeDesc::FLOAT),
                   texels);
    }

    Outcome bake(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"bake",         scratch.path("d65.exr"),
                                       "-o",           scratch.path("o.exr"),
                                       "--space",      "xyz",
                                       "--illuminant", "D65",
                                       "-d",           "float"};
        words.insert(words.end(), more.begin(), more.end());
        return runTool(words);
    }

    std::vector<double> baked(std::size_t patch) const {
        const auto bands = ReadBack(scratch.path("o.exr")).bands(int(patch % 6), int(patch / 6));
        return {bands.begin(), bands.end()};
    }

    Scratch scratch;
    std::vector<std::vector<double>> patches;
};

double apart(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

double meanDifference(const Chart& chart) {
    double sum = 0;
    for (std::size_t i = 0; i < chart.patches.size(); ++i) {
        const auto found = chart.baked(i);
        for (std::size_t m = 0; m < found.size(); ++m) {
            sum += std::abs(found[m] - chart.patches[i][m]) / double(24 * found.size());
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("both colours are met, and spectra come nearer to the measured ones") {
    const Chart chart;
    REQUIRE(chart.bake({}).exitCode == 0);
    const double without = meanDifference(chart);
    const std::string stats = chart.scratch.path("s.json");
    const Outcome baked =
        chart.bake({"--second", "A=" + chart.scratch.path("a.exr"), "--stats", stats});
    REQUIRE(baked.exitCode == 0);
    for (std::size_t i = 0; i < chart.patches.size(); ++i) {
        for (const char* light : {"D65", "A"}) {
            // Floats of the texels and of the bands: 2^-24 of values below 1.2, and of 81 of them.
            CHECK(apart(colorUnder(light, chart.baked(i)), colorUnder(light, chart.patches[i])) <=
                  4e-7);
        }
    }
    CHECK(meanDifference(chart) < 0.7 * without);
    CHECK(nlohmann::json::parse(contentsOf(stats))["second_missed_texels"] == 0);
    const auto spec = ReadBack(chart.scratch.path("o.exr")).spec;
    CHECK(spec.get_string_attribute("specbake:secondIlluminant") == "A");
    CHECK(spec.get_string_attribute("specbake:secondImage") == "a.exr");
    CHECK(
        runTool({"verify", chart.scratch.path("o.exr"), chart.scratch.path("d65.exr")}).exitCode ==
        0);
}

TEST_CASE("colours that no reflectance has together are counted, and the first is kept") {
    const Chart chart;
    chart.write("b.exr", "D65", 6);  // too blue for A by far
    const Outcome baked = chart.bake({"--second", "A=" + chart.scratch.path("b.exr")});
    REQUIRE(baked.exitCode == 0);
    CHECK(baked.err.find("texels have colours that no reflectance has under both") !=
          std::string::npos);
    for (std::size_t i = 0; i < chart.patches.size(); ++i) {
        CHECK(apart(colorUnder("D65", chart.baked(i)), colorUnder("D65", chart.patches[i])) <=
              4e-7);
    }
}

TEST_CASE("what cannot be a second texture is refused") {
    const Chart chart;
    chart.write("turned.exr", "A", 4);
    const std::string good = chart.scratch.path("a.exr");
    CHECK(chart.bake({"--second", good}).exitCode == 2);
    CHECK(chart.bake({"--second", "A="}).exitCode == 2);
    CHECK(chart.bake({"--second", "Z=" + good}).exitCode == 2);
    CHECK(chart.bake({"--second", "D65=" + good}).exitCode == 2);
    CHECK(chart.bake({"--second", "d65=" + good}).exitCode == 2);
    CHECK(chart.bake({"--second", "A=" + good, "--max-de", "0.1"}).exitCode == 2);
    CHECK(runTool({"bake", good, chart.scratch.path("d65.exr"), "-o", chart.scratch.path("all"),
                   "--second", "A=" + good})
              .exitCode == 2);
    CHECK(chart.bake({"--second", "A=" + chart.scratch.path("absent.exr")}).exitCode == 1);
    const Outcome turned = chart.bake({"--second", "A=" + chart.scratch.path("turned.exr")});
    CHECK(turned.exitCode == 1);
    CHECK(turned.err.find("has the size of its texture, 6 x 4, not 4 x 6") != std::string::npos);
    CHECK(chart.scratch.names() == std::vector<std::string>{"a.exr", "d65.exr", "turned.exr"});
}

TEST_CASE("-u bakes again when the second texture has changed, and only then") {
    const Chart chart;
    const std::string second = chart.scratch.path("a.exr");
    const auto update = [&](const std::string& light) {
        return chart.bake({"-u", "-v", "--second", light + "=" + second}).out;
    };
    CHECK(update("A").find("texels") != std::string::npos);
    CHECK(update("a").find("is up to date") != std::string::npos);
    chart.write("a.exr", "F11", 6);
    CHECK(update("A").find("texels") != std::string::npos);
    CHECK(update("D50").find("texels") != std::string::npos);
}
