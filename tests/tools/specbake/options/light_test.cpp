#include "process.h"
#include "support/csv.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

using namespace specbake::testing;

namespace {

using Names = std::vector<std::string>;

/// A column of a table in data/, one number a band.
std::vector<double> column(const std::string& table, const std::string& name) {
    std::vector<double> values;
    std::size_t at = 0;
    for (const std::string& line :
         linesOf(contentsOf(std::string(SPECBAKE_SOURCE_DIR) + "/data/" + table))) {
        if (line.empty() || line.front() == '#') continue;
        Names cells;
        std::string cell;
        for (const char c : line + ',') {
            if (c != ',') {
                cell += c;
            } else {
                cells.push_back(cell);
                cell.clear();
            }
        }
        if (at == 0) {
            at = std::size_t(std::find(cells.begin(), cells.end(), name) - cells.begin());
            REQUIRE(at < cells.size());
        } else {
            values.push_back(std::stod(cells.at(at)));
        }
    }
    REQUIRE(values.size() == 81);
    return values;
}

/// As a file: each power times `factor`, between words.
std::string tableOf(const std::vector<double>& powers, const std::string& before,
                    const std::string& between, double factor = 1) {
    std::string text;
    for (std::size_t m = 0; m < powers.size(); ++m) {
        char number[40];
        std::snprintf(number, sizeof number, "%.17g", factor * powers[m]);
        text += before + std::to_string(380 + 5 * m) + between + number + "\n";
    }
    return text;
}

std::string bakedUnder(const std::string& light) {
    const Scratch scratch;
    const Outcome outcome = runTool(
        {"bake", testImage("17x33.png"), "-q", "-o", scratch.path("o.exr"), "--illuminant", light});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    return contentsOf(scratch.path("o.exr"));
}

std::vector<double> whiteOf(const std::string& light) {
    const Outcome outcome = runTool({"region", "--illuminant", light, "--json"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    return nlohmann::json::parse(outcome.out).at("white").get<std::vector<double>>();
}

}  // namespace

TEST_SUITE_BEGIN("light");

TEST_CASE("a file with the powers of D65 gives the bytes that its name gives") {
    const Scratch scratch;
    const auto powers = column("illuminants_5nm.csv", "D65");
    const std::string byName = bakedUnder("D65");
    const std::string files[] = {
        "lambda_nm,power\n" + tableOf(powers, "", ","), "# pbrt\n" + tableOf(powers, "", " "),
        tableOf(powers, "  ", ";\t", 0.0123), tableOf(powers, "Spectral Data ", "[nm],", 7)};
    for (const std::string& file : files) {
        writeFile(scratch.path("mine.csv"), file);
        CHECK(bakedUnder(scratch.path("mine.csv")) == byName);
    }
    std::string cgats =
        "SPECT\n\nSPECTRAL_BANDS \"81\"\nSPECTRAL_START_NM \"380.0\"\n"
        "SPECTRAL_END_NM \"780.0\"\nBEGIN_DATA\n";
    for (const double power : powers) cgats += std::to_string(power) + " ";
    writeFile(scratch.path("mine.sp"), cgats + "\nEND_DATA\n");
    CHECK(bakedUnder(scratch.path("mine.sp")) == byName);
}

TEST_CASE("the white of a light is the 81-term sum over its table") {
    const auto x = column("cie1931_2deg_5nm.csv", "xbar");
    const auto y = column("cie1931_2deg_5nm.csv", "ybar");
    const auto z = column("cie1931_2deg_5nm.csv", "zbar");
    const Scratch scratch;
    for (const char* name : {"LED-B3", "F1", "F3.15", "HP1", "ID65", "LED-RGB1"}) {
        CAPTURE(name);
        const auto power = column("illuminants_further_5nm.csv", name);
        double sums[3] = {};
        for (std::size_t m = 0; m < power.size(); ++m) {
            sums[0] += x[m] * power[m];
            sums[1] += y[m] * power[m];
            sums[2] += z[m] * power[m];
        }
        const auto white = whiteOf(name);
        CHECK(std::abs(white[0] - sums[0] / sums[1]) < 1e-12);  // 81 roundings of 2^-53
        CHECK(std::abs(white[2] - sums[2] / sums[1]) < 1e-12);
    }
}

TEST_CASE("finer samples are averaged around the bands, coarser ones joined by lines") {
    const Scratch scratch;
    std::string fine;
    std::string coarse;
    for (int nm = 380; nm <= 780; ++nm) {
        // A line has its own mean around each band, and its own values between samples.
        const std::string sample = std::to_string(nm) + " " + std::to_string(nm - 300) + "\n";
        fine += sample;
        if (nm % 20 == 0) coarse += sample;
    }
    std::vector<double> line;
    for (int m = 0; m < 81; ++m) line.push_back(80 + 5 * m);
    // At the ends the triangle is cut in half: the mean moves by up to 4/3 nm of 80.
    writeFile(scratch.path("bands.csv"), tableOf(line, "", ","));
    writeFile(scratch.path("coarse.csv"), coarse);
    writeFile(scratch.path("fine.csv"), fine);
    CHECK(whiteOf(scratch.path("coarse.csv")) == whiteOf(scratch.path("bands.csv")));
    const auto fromFine = whiteOf(scratch.path("fine.csv"));
    const auto fromBands = whiteOf(scratch.path("bands.csv"));
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(fromFine[i] - fromBands[i]) < 1e-4);
}

TEST_CASE("a file under a light of one's own carries it: verify needs no other file") {
    const Scratch scratch;
    auto powers = column("illuminants_further_5nm.csv", "LED-B3");
    for (double& power : powers) power += 1;
    writeFile(scratch.path("lamp.csv"), tableOf(powers, "", ","));
    const std::string output = scratch.path("o.exr");
    const Outcome baked = runTool({"bake", testImage("17x33.png"), "-v", "-o", output,
                                   "--illuminant", scratch.path("lamp.csv")});
    REQUIRE(baked.exitCode == 0);
    CHECK(baked.out.find("(srgb, lamp.csv)") != std::string::npos);
    std::remove(scratch.path("lamp.csv").c_str());
    const Outcome verified = runTool({"verify", output, testImage("17x33.png")});
    CAPTURE(verified.out);
    CHECK(verified.exitCode == 0);
    CHECK(verified.out.find("under lamp.csv:") != std::string::npos);
    CHECK(runTool({"verify", output, testImage("17x33.png"), "--illuminant", "A"}).exitCode == 3);
}

TEST_CASE("what is no light is refused in one line") {
    const Scratch scratch;
    struct Case {
        std::string contents, says;
    };
    const std::string line = "380 1\n780 1\n";
    for (const Case& c :
         {Case{"", "no table"}, Case{"nm,power\n", "no table"}, Case{"380 1\n", "fewer than two"},
          Case{"780 1\n380 1\n", "ascend"}, Case{"380 -1\n780 1\n", "at least 0"},
          Case{"380 0\n780 0\n", "without power"}, Case{"500 1\n600 1\n", "400 nm"},
          Case{"380 1\n380 2\n780 1\n", "ascend"}}) {
        writeFile(scratch.path("bad.csv"), c.contents);
        const Outcome outcome = runTool({"region", "--illuminant", scratch.path("bad.csv")});
        CAPTURE(outcome.err);
        CHECK(outcome.exitCode == 1);
        CHECK(linesOf(outcome.err).size() == 1);
        CHECK(outcome.err.find(c.says) != std::string::npos);
    }
    const Outcome unknown = runTool({"region", "--illuminant", "D56"});
    CHECK(unknown.exitCode == 2);
    CHECK(unknown.err.find("did you mean 'D5") != std::string::npos);
}

TEST_SUITE_END();
