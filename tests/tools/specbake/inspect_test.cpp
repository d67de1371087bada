#include "process.h"
#include "read_back.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace specbake::testing;

namespace {

std::string baked(const Scratch& scratch, const std::string& image) {
    const std::string path = scratch.path("s.exr");
    REQUIRE(runTool({"bake", "-q", testImage(image), "-o", path, "-d", "float"}).exitCode == 0);
    return path;
}

std::string inspected(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "inspect");
    const Outcome outcome = runTool(arguments);
    CHECK(outcome.err == "");
    REQUIRE(outcome.exitCode == 0);
    return outcome.out;
}

int occurrences(const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_SUITE_BEGIN("inspect");

TEST_CASE("--at prints what the file holds, counted as its windows are") {
    const Scratch scratch;
    const std::string path = baked(scratch, "offset.exr");
    const ReadBack file(path);
    const auto lines = linesOf(inspected({path, "--at", "-7", "5", "--at", "2", "11"}));
    REQUIRE(lines.size() == 82);
    CHECK(lines[0] == "wavelength_nm,\"(-7, 5)\",\"(2, 11)\"");
    for (std::size_t band = 0; band < 81; ++band) {
        std::istringstream line(lines[band + 1]);
        int nm = 0;
        float first = 0;
        float second = 0;
        char comma = 0;
        line >> nm >> comma >> first >> comma >> second;
        CHECK(nm == 380 + 5 * int(band));
        CHECK(first == file.bands(0, 0)[band]);  // nine digits tell floats apart
        CHECK(second == file.bands(9, 6)[band]);
    }
}

TEST_CASE("--json holds the facts of the file") {
    const Scratch scratch;
    const std::string path = baked(scratch, "rgba16.png");
    const ReadBack file(path);
    const auto json = nlohmann::json::parse(inspected({path, "--json"}));
    CHECK(json.at("data_window").at("width") == 24);
    CHECK(json.at("data_window").at("height") == 16);
    CHECK(json.at("channels") == 85);
    CHECK(json.at("alpha") == true);
    CHECK(json.at("sample_type") == "float");
    CHECK(json.at("compression") == "zip");
    CHECK(json.at("attributes").at("specbake:illuminant") == "D65");
    float least = 2;
    float largest = -1;
    double sum = 0;
    for (int i = 0; i < 24 * 16; ++i) {
        for (const float value : file.bands(i % 24, i / 24)) {
            least = std::min(least, value);
            largest = std::max(largest, value);
            sum += double(value) / (24 * 16 * 81);
        }
    }
    CHECK(json.at("reflectance").at("min").get<float>() == least);
    CHECK(json.at("reflectance").at("max").get<float>() == largest);
    CHECK(std::abs(json.at("reflectance").at("mean").get<double>() - sum) < 1e-12);
    CHECK(json.at("reflectance").at("out_of_range") == 0);
}

TEST_CASE("the text says what the JSON does") {
    const Scratch scratch;
    const std::string path = baked(scratch, "1x37.png");
    const std::string text = inspected({path});
    CHECK(text.starts_with(path + ": 1 x 37 texels, 84 channels of float, compression zip\n"));
    CHECK(text.find("81, 380 to 780 nm every 5 nm\n") != std::string::npos);
    CHECK(text.find("specbake:colorspace: srgb\n") != std::string::npos);
}

TEST_CASE("--plot draws a curve a texel, or each band's extremes and mean") {
    const Scratch scratch;
    const std::string path = baked(scratch, "rgb8.png");
    const std::string plot = scratch.path("p.svg");
    CHECK(linesOf(inspected({path, "--at", "0", "0", "--plot", plot})).size() == 82);
    const std::string white = contentsOf(plot);
    CHECK(white.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    CHECK(white.ends_with("</svg>\n"));
    CHECK(white.find("wavelength (nm)") != std::string::npos);
    CHECK(white.find("prefers-color-scheme: dark") != std::string::npos);
    CHECK(occurrences(white, "<polyline") == 1);
    // White runs along the top of the axes, y = 44, at each of the 81 wavelengths.
    CHECK(occurrences(white, ",44.0 ") == 81);
    inspected({path, "--plot", plot});
    CHECK(occurrences(contentsOf(plot), "<polyline") == 3);
    CHECK(scratch.names() == std::vector<std::string>{"p.svg", "s.exr"});
}

TEST_CASE("what is not there is refused") {
    const Scratch scratch;
    const std::string path = baked(scratch, "1x1.png");
    const auto exitCode = [](const std::vector<std::string>& arguments) {
        const Outcome outcome = runTool(arguments);
        CHECK(linesOf(outcome.err).size() == 1);
        return outcome.exitCode;
    };
    CHECK(exitCode({"inspect", path, "--at", "1", "0"}) == 2);
    CHECK(exitCode({"inspect", path, "--at", "0", "-1"}) == 2);
    CHECK(exitCode({"inspect", path, "--at", "0"}) == 2);
    CHECK(exitCode({"inspect", testImage("rgb_half.exr")}) == 1);
    CHECK(exitCode({"inspect", path, "--plot", scratch.path("absent/p.svg")}) == 1);
}

TEST_SUITE_END();
