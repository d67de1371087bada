#include "process.h"
#include "read_back.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace specbake::testing;

TEST_SUITE_BEGIN("observer");

namespace {

using Words = std::vector<std::string>;
using Json = nlohmann::json;

const std::string kWideTable = std::string(SPECBAKE_SOURCE_DIR) + "/data/cie1964_10deg_1nm.csv";

/// Every `step`th row of the table of 10 degrees, between other words and marks.
std::string rowsOf(int step) {
    std::string text = "CIE 1964;x;y;z\n";
    int row = 0;
    for (std::string line : linesOf(contentsOf(kWideTable))) {
        if (line.empty() || line.front() < '0' || line.front() > '9') continue;
        for (char& c : line) c = c == ',' ? ';' : c;
        if (row++ % step == 0) text += line + "\n";
    }
    return text;
}

void bake(const std::string& output, Words options, const std::string& texture = "rgb8.png") {
    const Words first = {"bake", "-q", testImage(texture), "-o", output};
    options.insert(options.begin(), first.begin(), first.end());
    const Outcome outcome = runTool(options);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exitCode == 0);
}

int verified(const std::string& spectral, Words options, const std::string& texture = "rgb8.png") {
    const Words first = {"verify", spectral, testImage(texture)};
    options.insert(options.begin(), first.begin(), first.end());
    const Outcome outcome = runTool(options);
    INFO(outcome.out, outcome.err);
    CHECK(outcome.err.empty());
    return outcome.exitCode;
}

Json region(Words options) {
    options.insert(options.begin(), {"region", "--json"});
    const Outcome outcome = runTool(options);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    return Json::parse(outcome.out);
}

}  // namespace

TEST_CASE("a file with the table of 10 degrees gives the bytes that --observer 10 gives") {
    const Scratch scratch;
    bake(scratch.path("name.exr"), {"--observer", "10"});
    writeFile(scratch.path("five.txt"), rowsOf(5));
    for (const std::string& file : {kWideTable, scratch.path("five.txt")}) {
        bake(scratch.path("file.exr"), {"--observer", file});
        CHECK(contentsOf(scratch.path("file.exr")) == contentsOf(scratch.path("name.exr")));
    }
    bake(scratch.path("usual.exr"), {});
    bake(scratch.path("two.exr"), {"--observer", "2"});
    CHECK(contentsOf(scratch.path("two.exr")) == contentsOf(scratch.path("usual.exr")));
    CHECK(contentsOf(scratch.path("two.exr")) != contentsOf(scratch.path("name.exr")));
}

TEST_CASE("a file says who sees its colours, and verify goes by it") {
    const Scratch scratch;
    const std::string file = scratch.path("o.exr");
    writeFile(scratch.path("ten.csv"), rowsOf(10));
    for (const char* texture : {"rgb8.png", "xyz_float.exr", "acescg_half.exr"}) {
        for (const Words& options :
             {Words{"--observer", "10"}, Words{"--observer", "10", "--illuminant", "F11"},
              Words{"--observer", "10", "--quadrature", "fine"},
              Words{"--observer", "10", "--wavelengths", "400:700:10"},
              Words{"--observer", scratch.path("ten.csv")},
              Words{"--observer", scratch.path("ten.csv"), "--quadrature", "fine"}}) {
            CAPTURE(texture);
            CAPTURE(options.back());
            bake(file, options, texture);
            CHECK(verified(file, {"--max-de", "0.2"}, texture) == 0);
            CHECK(verified(file, {"--observer", "2"}, texture) == 3);
        }
    }
    bake(file, {"--observer", "10"});
    CHECK(ReadBack(file).spec.get_string_attribute("specbake:observer") ==
          "CIE 1964 10 degree, 5 nm");
    const Outcome told = runTool({"verify", file, testImage("rgb8.png")});
    CHECK(told.out.find("under D65, CIE 1964 10 degree:") != std::string::npos);
}

TEST_CASE("solve: the spectrum has the colour by the sum over the table") {
    const Outcome outcome =
        runTool({"solve", "--xyz", ".3", ".25", ".2", "--observer", "10", "--json"});
    REQUIRE(outcome.exitCode == 0);
    const Json solution = Json::parse(outcome.out);
    CHECK(solution["observer"] == "CIE 1964 10 degree");
    double x = 0;
    double y = 0;
    double luminance = 0;
    std::size_t band = 0;
    for (const std::string& line : linesOf(rowsOf(5))) {
        if (line.empty() || line.front() < '3' || line.front() > '9') continue;
        const int nm = std::stoi(line);
        if (nm < 380 || nm > 780) continue;
        const auto next = line.find(';', 4);
        const double r = solution["reflectance"][band++];
        x += r * std::stod(line.substr(4));
        y += r * std::stod(line.substr(next + 1));
        luminance += std::stod(line.substr(next + 1));
    }
    CHECK(band == 81);
    CHECK(std::abs(x / luminance - 0.3) < 1e-12);
    CHECK(std::abs(y / luminance - 0.25) < 1e-12);
}

TEST_CASE("relight: white is white to every eye, and a tint to one that has not adapted") {
    const Scratch scratch;
    bake(scratch.path("o.exr"), {}, "grey8.png");
    for (const char* observer : {"2", "10"}) {
        CAPTURE(observer);
        const std::string picture = scratch.path("p.exr");
        REQUIRE(runTool({"relight", "-q", scratch.path("o.exr"), "-o", picture, "--illuminant",
                         "F2", "--observer", observer})
                    .exitCode == 0);
        const ReadBack adapted(picture);
        double tint = 0;
        for (std::size_t i = 0; i < adapted.samples.size();
             i += std::size_t(adapted.spec.nchannels)) {
            tint = std::fmax(tint, std::fabs(adapted.samples[i] - adapted.samples[i + 2]));
        }
        CHECK(tint < 2e-3);
    }
}

TEST_CASE("region: of any observer, quadrature and wavelengths, the mesh is closed") {
    const Scratch scratch;
    writeFile(scratch.path("ten.csv"), rowsOf(10));
    for (const Words& options :
         {Words{"--observer", "10"}, Words{"--observer", scratch.path("ten.csv")},
          Words{"--quadrature", "fine"}, Words{"--wavelengths", "400:700:10"},
          Words{"--wavelengths", "360:830:1", "--observer", "10"}}) {
        CAPTURE(options.back());
        const Json facts = region(options);
        // Euler: every parallelogram has four edges, every edge two faces.
        const int faces = facts["parallelograms"].get<int>() + 2;
        const int edges = 2 * facts["parallelograms"].get<int>() + facts["base_sides"].get<int>();
        CHECK(facts["vertices"].get<int>() + faces == edges + 2);
        CHECK(facts["parallelograms"].get<int>() == 2 * facts["pairs"].get<int>());
    }
    CHECK(region({"--observer", "10"})["observer"] == "CIE 1964 10 degree, 5 nm");
    CHECK(region({"--wavelengths", "400:700:10"})["quadrature"] == "fine");
}

TEST_CASE("a table for renderers says its observer") {
    const Scratch scratch;
    const std::string path = scratch.path("t.spectab");
    REQUIRE(runTool({"table", "-o", path, "--grid", "5", "--observer", "10"}).exitCode == 0);
    CHECK(contentsOf(path).find("\nobserver=CIE 1964 10 degree, 5 nm\n") != std::string::npos);
}

TEST_CASE("what is no observer is refused in one line") {
    const Scratch scratch;
    writeFile(scratch.path("light.csv"), "380,1\n780,1\n");
    writeFile(scratch.path("negative.csv"), "380,-1,1,1\n390,1,1,1\n");
    for (const std::string& word : {std::string("20"), scratch.path("absent.csv"),
                                    scratch.path("light.csv"), scratch.path("negative.csv")}) {
        CAPTURE(word);
        const Outcome outcome = runTool({"region", "--observer", word});
        CHECK(outcome.exitCode != 0);
        CHECK(linesOf(outcome.err).size() == 1);
    }
}

TEST_SUITE_END();
