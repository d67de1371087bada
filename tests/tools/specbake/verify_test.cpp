#include "process.h"
#include "read_back.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <limits>

using namespace specbake::testing;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A bake of an image with alpha, and what can be done to it by another program.
class Tampering {
  public:
    explicit Tampering(const std::string& image = "rgba8.png") : texture_(testImage(image)) {
        REQUIRE(runTool({"bake", "-q", texture_, "-o", original()}).exitCode == 0);
    }

    std::string original() const { return scratch_.path("original.exr"); }
    std::string texture() const { return texture_; }

    /// The spectral file with a channel changed at (3, 2).
    std::string withSample(const std::string& channel, const std::function<float(float)>& change) {
        ReadBack file(original());
        const auto c = std::size_t(file.spec.channelindex(channel));
        const std::size_t texel = std::size_t(file.spec.width) * 2 + 3;
        float& sample = file.samples.at(texel * std::size_t(file.spec.nchannels) + c);
        sample = change(sample);
        return write(file);
    }
    std::string withAttribute(const std::string& name, const std::string& value) {
        ReadBack file(original());
        file.spec.attribute(name, value);
        return write(file);
    }

    Outcome verify(const std::string& spectral, std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"verify", spectral, texture_});
        return runTool(options);
    }

  private:
    std::string write(const ReadBack& file) {
        const std::string path = scratch_.path("tampered.exr");
        OIIO::ImageSpec spec = file.spec;
        spec["oiio:UnassociatedAlpha"] = 0;  // samples as they are
        writeImage(path, spec, file.samples);
        return path;
    }

    Scratch scratch_;
    std::string texture_;
};

float raised(float value) {
    return value + (value < 0.5F ? 0.01F : -0.01F);
}

bool says(const Outcome& outcome, const std::string& words) {
    return outcome.out.find(words) != std::string::npos;
}

}  // namespace

TEST_SUITE_BEGIN("verify");

TEST_CASE("another program's copy of a bake passes") {
    Tampering file;
    CHECK(file.verify(file.original()).exitCode == 0);
    CHECK(file.verify(file.withAttribute("comment", "copied")).exitCode == 0);
}

TEST_CASE("one band of one texel off by 0.01 does not pass") {
    Tampering file;
    for (const int nm : {450, 500, 550, 600}) {
        CAPTURE(nm);
        const Outcome outcome = file.verify(file.withSample(bandName(nm), raised));
        CHECK(outcome.exitCode == 3);
        CHECK(says(outcome, "1 texels differ by more than the rounding"));
    }
}

TEST_CASE("a band that no colour shows is found by --spectra, with its texel and wavelength") {
    Tampering file;
    const auto half = [](float value) { return value < 0.5F ? value + 0.5F : value - 0.5F; };
    const std::string tampered = file.withSample(bandName(780), half);
    CHECK(file.verify(tampered).exitCode == 0);
    const Outcome outcome = file.verify(tampered, {"--spectra", file.original()});
    CHECK(outcome.exitCode == 3);
    CHECK(says(outcome, "at (3, 2), 780 nm"));
    const Outcome alone = runTool({"verify", "--json", tampered, "--spectra", file.original()});
    CHECK(alone.exitCode == 3);
    const auto spectra = nlohmann::json::parse(alone.out).at("spectra");
    CHECK(spectra.at("max_abs") == doctest::Approx(0.5).epsilon(1e-3));
    CHECK(spectra.at("worst_nm") == 780);
    CHECK(runTool({"verify", tampered, "--spectra", file.original(), "--max-band", "0.51"})
              .exitCode == 0);
    CHECK(runTool({"verify", file.original(), "--spectra", file.original()}).exitCode == 0);
}

TEST_CASE("the name of another light does not pass") {
    Tampering file;
    for (const char* light : {"D60", "D55", "E", "A", "F11"}) {
        CAPTURE(light);
        CHECK(file.verify(file.withAttribute("specbake:illuminant", light)).exitCode == 3);
        CHECK(file.verify(file.original(), {"--illuminant", light}).exitCode == 3);
        const std::string renamed = file.withAttribute("specbake:illuminant", light);
        CHECK(file.verify(renamed, {"--illuminant", "D65"}).exitCode == 0);
        // A limit that the user sets for the colours takes the place of rounding.
        CHECK(file.verify(renamed, {"--max-de", "100"}).exitCode == 0);
    }
}

TEST_CASE("a preview or an alpha of another picture does not pass") {
    Tampering file;
    for (const char* channel : {"R", "G", "B"}) {
        const Outcome preview = file.verify(file.withSample(channel, raised));
        CHECK(preview.exitCode == 3);
        CHECK(says(preview, "1 texels have a preview"));
    }
    const Outcome alpha = file.verify(file.withSample("A", raised));
    CHECK(alpha.exitCode == 3);
    CHECK(says(alpha, "1 texels have another alpha"));
    // Alpha that one of the two has not is 1 there.
    const Outcome missing = runTool({"verify", file.original(), testImage("rgb8.png")});
    CHECK(missing.exitCode == 3);
    CHECK(says(missing, "texels have another alpha"));
}

TEST_CASE("a number that is not finite never passes, in the file or in the texture") {
    Tampering file;
    const std::vector<std::string> anything = {"--max-de", "1000"};
    const std::string broken = file.withSample(bandName(600), [](float) { return kNaN; });
    CHECK(file.verify(broken, anything).exitCode == 3);
    CHECK(runTool({"verify", broken, "--spectra", file.original()}).exitCode == 3);
    CHECK(runTool({"verify", file.original(), "--spectra", broken}).exitCode == 3);

    const Scratch scratch;
    const std::string texture = scratch.path("nan.exr");
    ReadBack picture(testImage("rgb_float.exr"));
    const std::string baked = scratch.path("o.exr");
    REQUIRE(runTool({"bake", "-q", testImage("rgb_float.exr"), "-o", baked}).exitCode == 0);
    for (const float bad : {kNaN, std::numeric_limits<float>::infinity()}) {
        picture.samples[10] = bad;
        writeImage(texture, picture.spec, picture.samples);
        const Outcome outcome = runTool({"verify", baked, texture, "--max-de", "1000"});
        CHECK(outcome.exitCode == 3);
        CHECK(says(outcome, "1 texels have a number that is not finite"));
        CHECK(outcome.out.find("nan,") == std::string::npos);
    }
}

TEST_CASE(
    "names that are not known, and files that are not alike, are refused by the file's name") {
    Tampering file;
    for (const char* name : {"illuminant", "observer", "outside"}) {
        CAPTURE(name);
        const std::string attribute = std::string("specbake:") + name;
        const std::string renamed = file.withAttribute(attribute, "moonshine");
        const Outcome outcome = file.verify(renamed);
        CHECK(outcome.exitCode == 1);
        CHECK(outcome.err.find(renamed + ": " + attribute + " is 'moonshine'") !=
              std::string::npos);
    }
    CHECK(file.verify(file.original(), {"--illuminant", "moonshine"}).exitCode == 2);
    CHECK(runTool({"verify", file.original()}).exitCode == 2);
    CHECK(runTool({"verify", file.original(), file.texture(), "--max-band", "1"}).exitCode == 2);

    const Scratch scratch;
    const std::string other = scratch.path("other.exr");
    REQUIRE(runTool({"bake", "-q", testImage("1x1.png"), "-o", other}).exitCode == 0);
    const Outcome size = runTool({"verify", file.original(), "--spectra", other});
    CHECK(size.exitCode == 1);
    CHECK(size.err.find(other + " 1 x 1") != std::string::npos);
    REQUIRE(runTool({"bake", "-q", testImage("rgb8.png"), "-o", other}).exitCode == 0);
    const Outcome channels = runTool({"verify", file.original(), "--spectra", other});
    CHECK(channels.exitCode == 1);
    CHECK(channels.err.find("has a channel A") != std::string::npos);
}

TEST_CASE("large differences have their true percentile") {
    const Scratch scratch;
    const std::string black = scratch.path("black.exr");
    const std::string white = scratch.path("white.exr");
    OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeFloat);
    writeImage(black, spec, std::vector<float>(8 * 8 * 3, 0.0F));
    writeImage(white, spec, std::vector<float>(8 * 8 * 3, 1.0F));
    const std::string baked = scratch.path("o.exr");
    REQUIRE(runTool({"bake", "-q", black, "-o", baked}).exitCode == 0);
    const Outcome outcome = runTool({"verify", "--json", baked, white});
    CHECK(outcome.exitCode == 3);
    const auto difference = nlohmann::json::parse(outcome.out).at("de2000");
    // CIEDE2000 of L = 100 beside 0: ΔL' = 100, S_L = 1 at the mean of 50.
    CHECK(difference.at("max") == doctest::Approx(100).epsilon(1e-9));
    CHECK(difference.at("p99") == difference.at("max"));
    CHECK(difference.at("mean") == difference.at("max"));
}

TEST_CASE("a texture is read by another reader too, or there is none, and verify says which") {
    const Scratch scratch;
    const std::string baked = scratch.path("o.exr");
    const std::vector<std::pair<std::string, std::string>> readings = {
        {"rgb8.png", "rgb8.png: OpenImageIO reads the same"},
        {"grey16.png", "grey16.png: OpenImageIO reads the same"},
        {"rgb8.jpg", "rgb8.jpg: OpenImageIO reads the same"},
        {"rgb8.tif", "rgb8.tif: only one reader knows this file"}};
    for (const auto& [image, words] : readings) {
        CAPTURE(image);
        REQUIRE(runTool({"bake", "-q", testImage(image), "-o", baked}).exitCode == 0);
        const Outcome outcome = runTool({"verify", baked, testImage(image)});
        CHECK(outcome.exitCode == 0);
        CHECK(says(outcome, words));
        CHECK(!says(runTool({"verify", "--no-independent", baked, testImage(image)}), words));
    }
}

TEST_SUITE_END();
