#include "process.h"
#include "read_back.h"

#include <specbake/bake/bake.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace specbake;
using namespace specbake::testing;

namespace {

/// The spectral image of a test image, by the program.
ReadBack bakedByProgram(const std::string& image) {
    const Scratch scratch;
    const Outcome outcome = runTool({"bake", "-q", testImage(image), "-o", scratch.path("o.exr")});
    CHECK(outcome.err == "");
    CHECK(outcome.out == "");
    REQUIRE(outcome.exitCode == 0);
    return ReadBack(scratch.path("o.exr"));
}

/// The same by the library, which takes less time than starting the program. Floats.
ReadBack baked(const std::string& image, BakeOptions options = {}) {
    const Scratch scratch;
    options.storage.sampleType = SampleType::float32;
    bake(testImage(image), scratch.path("o.exr"), options);
    return ReadBack(scratch.path("o.exr"));
}

void checkChannels(const ReadBack& file, bool alpha, OIIO::TypeDesc type) {
    CHECK(file.spec.nchannels == 84 + (alpha ? 1 : 0));
    CHECK((file.spec.channelindex("A") >= 0) == alpha);
    for (const char* name : {"R", "G", "B"}) CHECK(file.spec.channelindex(name) >= 0);
    for (int nm = 380; nm <= 780; nm += 5) CHECK(file.spec.channelindex(bandName(nm)) >= 0);
    // OpenImageIO lists types by channel only where they differ.
    CHECK(file.spec.channelformats.empty());
    CHECK(file.spec.format == type);
    CHECK(file.spec.get_string_attribute("spectralLayoutVersion") == "1.0");
}

void checkWindows(const OIIO::ImageSpec& a, const OIIO::ImageSpec& b) {
    CHECK(std::array{a.x, a.y, a.width, a.height} == std::array{b.x, b.y, b.width, b.height});
    CHECK(std::array{a.full_x, a.full_y, a.full_width, a.full_height} ==
          std::array{b.full_x, b.full_y, b.full_width, b.full_height});
}

}  // namespace

TEST_SUITE_BEGIN("spectral_file");

TEST_CASE("the file holds 81 bands, a preview, alpha if the texture has it, all of one type") {
    for (const std::string& image : testImages()) {
        CAPTURE(image);
        const OIIO::ImageSpec texture = ReadBack(testImage(image)).spec;
        const bool alpha = texture.alpha_channel >= 0;
        const ReadBack file = bakedByProgram(image);
        checkChannels(file, alpha, OIIO::TypeHalf);
        checkWindows(file.spec, texture);
    }
    checkChannels(baked("rgba8.png"), true, OIIO::TypeFloat);
    checkChannels(baked("rgb8.png"), false, OIIO::TypeFloat);
}

TEST_CASE("metadata is kept, and it is said how the file was made") {
    const OIIO::ImageSpec exr = baked("rgb_float.exr").spec;
    CHECK(exr.get_string_attribute("Copyright") == "testimages");
    CHECK(exr.get_string_attribute("ImageDescription") == "a colour wheel");
    CHECK(exr.get_string_attribute("DateTime") == "2000:01:01 00:00:00");
    CHECK(exr.get_float_attribute("FocalLength") == 35);
    CHECK(exr.get_float_attribute("PixelAspectRatio") == 2);
    const OIIO::ImageSpec tiff = baked("rgb8.tif").spec;
    CHECK(tiff.get_string_attribute("ImageDescription") == "a colour wheel");
    CHECK(tiff.get_string_attribute("Artist") == "testimages");
    CHECK(std::string(tiff.get_string_attribute("Software")).starts_with("specbake "));
}

TEST_CASE("the colour space and its light are those that the file names") {
    const auto names = [](const std::string& image, const BakeOptions& options = {}) {
        const OIIO::ImageSpec spec = baked(image, options).spec;
        return std::string(spec.get_string_attribute("specbake:colorspace")) + " " +
               std::string(spec.get_string_attribute("specbake:illuminant"));
    };
    BakeOptions lamp;
    lamp.model.illuminant = "A";
    BakeOptions linear;
    linear.color.space = "lin_rec709";
    CHECK(names("rgb8.png") == "srgb D65");
    CHECK(names("rgba8.png") == "srgb D65");
    CHECK(names("rgb16_tiled.tif") == "srgb D65");
    CHECK(names("rgb.hdr") == "lin_rec709 D65");
    CHECK(names("rgb_half.exr") == "lin_rec709 D65");
    CHECK(names("acescg_half.exr") == "acescg D60");
    CHECK(names("rec2020_float.exr") == "lin_rec2020 D65");
    CHECK(names("xyz_float.exr") == "xyz E");
    CHECK(names("rgb8.png", lamp) == "srgb A");
    CHECK(names("rgb8.png", linear) == "lin_rec709 D65");
}

TEST_CASE("white is 1 in every band and black 0, exactly; grey is flat") {
    for (const char* image : {"rgb8.png", "grey16.png", "rgb_float.exr"}) {
        CAPTURE(image);
        const ReadBack file = baked(image);
        for (const float s : file.bands(0, 0)) CHECK(s == 1.0F);
        for (const float s : file.bands(1, 0)) CHECK(s == 0.0F);
        const auto grey = file.bands(2, 0);
        const auto [least, largest] = std::minmax_element(grey.begin(), grey.end());
        CHECK(*largest - *least <= 1e-6F);
        CHECK(*least > 0);
    }
}

TEST_CASE("the preview shows the texture") {
    const ReadBack texture(testImage("rgb_float.exr"));
    const ReadBack file = baked("rgb_float.exr");
    for (int x = 0; x < texture.spec.width; ++x) {
        for (const char* channel : {"R", "G", "B"}) {
            // As for the bands (every_image_test.cpp), times the matrix's largest row sum, 5.3.
            CHECK(std::abs(file.at(x, 9, channel) - texture.at(x, 9, channel)) < 5.3e-6F);
        }
    }
}

TEST_CASE("reflectances are not multiplied by alpha") {
    // Rows 1 and 3 of the wheel with alpha 0.8 and 0.4, beside the wheel without alpha.
    const ReadBack opaque = baked("rgb_half.exr");
    const ReadBack exr = baked("rgba_half.exr");
    for (const int y : {0, 1, 3}) {
        CHECK(exr.at(5, y, "A") == doctest::Approx((5 - y) / 5.0).epsilon(0x1p-11));
        for (int x = 4; x < 24; ++x) {
            const auto a = exr.bands(x, y);
            const auto b = opaque.bands(x, y);
            // Colour and alpha are halves: a quotient off by 3 · 2⁻¹² of the colour. A band is off
            // by about as much of its spectrum's largest, 1, times 4 for steep places.
            for (std::size_t m = 0; m < 81; ++m) CHECK(std::abs(a[m] - b[m]) < 12 * 0x1p-12F);
        }
    }
}

TEST_CASE("what is transparent keeps the colour that it has") {
    const ReadBack texture(testImage("rgba8.png"));
    REQUIRE(texture.at(3, 5, "A") == 0);
    const ReadBack file = baked("rgba8.png");
    const ReadBack opaque = baked("rgb8.png");
    CHECK(file.at(3, 5, "A") == 0);
    CHECK(file.bands(3, 5) == opaque.bands(3, 5));
}

TEST_SUITE_END();
