#include "process.h"
#include "read_back.h"

#include <specbake/sampler.h>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using namespace specbake;
using namespace specbake::testing;

TEST_SUITE_BEGIN("quadrature");

namespace {

struct Baked {
    explicit Baked(std::vector<std::string> options, const std::string& texture = "rgb8.png")
        : input(testImage(texture)) {
        options.insert(options.begin(), {"bake", "-q", input, "-o", path});
        const Outcome outcome = runTool(options);
        CAPTURE(outcome.err);
        REQUIRE(outcome.exitCode == 0);
    }

    int verified(std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"verify", "-q", path, input});
        return runTool(options).exitCode;
    }

    Scratch scratch;
    std::string input;
    std::string path = scratch.path("baked.exr");
};

}  // namespace

TEST_CASE("a fine bake says so, and verify decides by what it says") {
    const Baked usual({"-d", "float"});
    const Baked fine({"-d", "float", "--quadrature", "fine"});
    CHECK(usual.verified() == 0);
    CHECK(fine.verified() == 0);
    CHECK(fine.verified({"--quadrature", "bands"}) == 3);
    CHECK(usual.verified({"--quadrature", "fine"}) == 3);
    const ReadBack file(fine.path);
    CHECK(file.spec.get_string_attribute("specbake:quadrature") ==
          "every 1 nm from 360 to 830 nm, linear between the bands, their ends repeated");
    CHECK(file.spec.get_string_attribute("specbake:observer") == "CIE 1931 2 degree, 1 nm");
    CHECK(ReadBack(usual.path).spec.find_attribute("specbake:quadrature") == nullptr);
}

TEST_CASE("a second light is met by the fine integral, too") {
    const std::string second = "A=" + testImage("rgb8.png");
    const Baked fine({"-d", "float", "--quadrature", "fine", "--second", second});
    CHECK(fine.verified() == 0);
    const Outcome refused = runTool({"bake", "-q", testImage("rgb8.png"), "-o", fine.path,
                                     "--second", second, "--wavelengths", "400:700:10"});
    CHECK(refused.exitCode != 0);
    CHECK(refused.err.find("380:780:5") != std::string::npos);
}

TEST_CASE("bands stand where --wavelengths says, under names that other programs read") {
    struct Case {
        const char* wavelengths;
        int first, step, count;
    };
    for (const Case& c : {Case{"400:700:10", 400, 10, 31}, Case{"360:830:5", 360, 5, 95},
                          Case{"380:780:1", 380, 1, 401}, Case{"380:780:5", 380, 5, 81}}) {
        for (const char* texture : {"rgb8.png", "rgba_half.exr", "acescg_half.exr", "1x1.png"}) {
            CAPTURE(c.wavelengths);
            CAPTURE(texture);
            const Baked baked({"--wavelengths", c.wavelengths}, texture);
            CHECK(baked.verified() == 0);
            const ReadBack file(baked.path);
            const bool alpha = file.spec.alpha_channel >= 0;
            REQUIRE(file.spec.nchannels == c.count + 3 + (alpha ? 1 : 0));
            for (int band = 0; band < c.count; ++band) {
                const float value = file.at(0, 0, bandName(c.first + band * c.step));
                REQUIRE((value >= 0 && value <= 1));
            }
        }
    }
}

TEST_CASE("tiles, mip levels, fewer bits, every compression and type take any wavelengths") {
    const std::vector<std::vector<std::string>> choices = {
        {"--mipmap"},           {"--tile", "32", "16"},      {"--bits", "7"},
        {"--max-de", "0.1"},    {"--max-deviation", "0.01"}, {"--per-texel"},
        {"-d", "float"},        {"--compression", "piz"},    {"--compression", "none"},
        {"--method", "natural"}};
    for (std::vector<std::string> options : choices) {
        CAPTURE(options[0]);
        options.insert(options.end(), {"--wavelengths", "400:700:20"});
        const bool fewer = options[0] == "--bits" || options[0] == "--max-de";
        CHECK(Baked(options).verified(fewer ? std::vector<std::string>{"--max-de", "0.5"}
                                            : std::vector<std::string>{}) == 0);
    }
}

TEST_CASE("threads do not change the bytes of other wavelengths") {
    for (const char* nm : {"400:700:10", "360:830:2"}) {
        const Baked one({"--wavelengths", nm, "-j", "1"});
        const Baked four({"--wavelengths", nm, "-j", "4"});
        CHECK(contentsOf(one.path) == contentsOf(four.path));
    }
}

TEST_CASE("relight and inspect read them") {
    const Baked baked({"--wavelengths", "400:700:10", "-d", "float"});
    const std::string picture = baked.scratch.path("lit.exr");
    REQUIRE(runTool({"relight", "-q", baked.path, "-o", picture, "--illuminant", "D65"}).exitCode ==
            0);
    // Under its own light the picture is the preview, but for the gain of relight.h, which is 1
    // where white is (1, 1, 1), and for negative values.
    const ReadBack lit(picture), file(baked.path);
    for (const char* channel : {"R", "G", "B"}) {
        CHECK(std::abs(lit.at(1, 1, channel) - file.at(1, 1, channel)) < 1e-5F);
    }
    const Outcome facts = runTool({"inspect", baked.path});
    CHECK(facts.out.find("31, 400 to 700 nm every 10 nm\n") != std::string::npos);
    const Outcome texel = runTool({"inspect", baked.path, "--at", "0", "0"});
    CHECK(linesOf(texel.out).size() == 32);
    CHECK(linesOf(texel.out)[1].starts_with("400,"));
    CHECK(runTool({"inspect", baked.path, "--plot", baked.scratch.path("p.svg")}).exitCode == 0);
}

TEST_CASE("spectral images of other programs are read, evenly spaced or not") {
    const Scratch scratch;
    const std::string path = scratch.path("other.exr");
    OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {bandName(400), bandName(500), bandName(550), bandName(700)};
    writeImage(path, spec, {1, 1, 1, 1, 0.5F, 0.5F, 0.5F, 0.5F});
    const Outcome facts = runTool({"inspect", path});
    CHECK(facts.exitCode == 0);
    CHECK(facts.out.find("4, 400 to 700 nm unevenly spaced\n") != std::string::npos);
    const std::string picture = scratch.path("lit.exr");
    REQUIRE(runTool({"relight", "-q", path, "-o", picture}).exitCode == 0);
    const ReadBack lit(picture);
    for (const char* channel : {"R", "G", "B"}) {
        CHECK(std::abs(lit.at(0, 0, channel) - 1) < 1e-3);  // halves
        CHECK(std::abs(lit.at(1, 0, channel) - 0.5F) < 1e-3F);
    }
    CHECK(runTool({"relight", "-q", path, "-o", picture, "--quadrature", "bands"}).exitCode == 1);
}

TEST_CASE("a band that a file of ours lacks is named") {
    const Scratch scratch;
    const std::string path = scratch.path("less.exr");
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {bandName(400), bandName(410), bandName(430)};
    spec.attribute("specbake:version", "0.1.0");
    spec.attribute("specbake:wavelengths", "400:430:10");
    writeImage(path, spec, {0, 0, 0});
    const Outcome outcome = runTool({"inspect", path});
    CHECK(outcome.exitCode == 1);
    CHECK(outcome.err.find("no channel " + bandName(420)) != std::string::npos);
}

TEST_CASE("solve gives the bands that are asked for") {
    const Outcome outcome =
        runTool({"solve", "--json", "--rgb", "0.8", "0.3", "0.1", "--wavelengths", "360:830:10"});
    REQUIRE(outcome.exitCode == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["reflectance"].size() == 48);
    CHECK(json["first_nm"] == 360);
    CHECK(json["quadrature"] == "fine");
    CHECK(json["residual"].get<double>() < 1e-10);
}

TEST_CASE("a table says its errors in both quadratures, on the screen and in the file") {
    const Scratch scratch;
    for (const char* quadrature : {"bands", "fine"}) {
        const std::string path = scratch.path(std::string(quadrature) + ".spectab");
        const Outcome made =
            runTool({"table", "-o", path, "--grid", "9", "--quadrature", quadrature});
        REQUIRE(made.exitCode == 0);
        CHECK(made.out.find("sum over the bands") != std::string::npos);
        CHECK(made.out.find("from 360 to 830 nm every 1 nm") != std::string::npos);
        const std::string bytes = contentsOf(path);
        const auto largest = [&](const std::string& name) {
            const auto at = bytes.find("\n" + name + "=");
            REQUIRE(at != std::string::npos);
            double mean = 0, p99 = 0, max = 0;
            REQUIRE(std::sscanf(bytes.c_str() + at + name.size() + 2, "%lf %lf %lf", &mean, &p99,
                                &max) == 3);
            return max;
        };
        const bool fine = std::string(quadrature) == "fine";
        // 16 bits are exact to 0.01; the two integrals differ by some 0.1 in saturated colours.
        CHECK((largest("de2000_fine") < 0.01) == fine);
        CHECK((largest("de2000_bands") < 0.01) == !fine);
    }
}

TEST_CASE("wavelengths that cannot be are refused before anything is written") {
    const Scratch scratch;
    const std::string path = scratch.path("x.exr");
    for (const char* nm : {"400:700:7", "100:700:10", "400:700", "red"}) {
        CHECK(runTool({"bake", testImage("rgb8.png"), "-o", path, "--wavelengths", nm}).exitCode ==
              2);
    }
    CHECK(runTool({"bake", testImage("rgb8.png"), "-o", path, "--wavelengths", "400:700:10",
                   "--quadrature", "bands"})
              .exitCode == 2);
    CHECK(scratch.names().empty());
}

TEST_SUITE_END();
