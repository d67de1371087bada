#include "texture/data_names.h"
#include "texture/kept_metadata.h"
#include "texture/openimageio/quirks.h"

#include <specbake/core/error.h>

#include <doctest/doctest.h>

using namespace specbake;
using namespace specbake::internal;

TEST_CASE("a name that says data gets a remark, one that says colours none") {
    for (const char* name : {"wood_nor_gl_1k.png", "Bricks075A_1K_Roughness.jpg", "wall-height.exr",
                             "rock_arm_4k.jpg", "x/y_mask.tif", "a.ao.png", "normal.png",
                             "tile_Normal.1001.tif", "metal_plate_metal_1k.png"}) {
        CAPTURE(name);
        CHECK(remarkOnName(name).has_value());
    }
    for (const char* name : {"wood.png", "metal_plate_02.jpg", "rough_wood_diff_1k.jpg",
                             "mask/wood.png", "Normandy.tif", "wood_normal_albedo.png", ""}) {
        CAPTURE(name);
        CHECK_FALSE(remarkOnName(name).has_value());
    }
}

TEST_CASE("a name that says another space than the one that is taken gets a remark") {
    const ColorSpace& linear = *findColorSpace("lin_rec709");
    const ColorSpace& encoded = *findColorSpace("srgb");
    const auto named = [](const std::string& path, const ColorSpace& taken) {
        const auto remark = remarkOnSpace(path, taken);
        const auto at = remark ? remark->find("--space ") : std::string::npos;
        return at == std::string::npos ? ""
                                       : remark->substr(at + 8, remark->find(' ', at + 8) - at - 8);
    };
    CHECK(named("wall_front_ACEScg.exr", linear) == "acescg");
    CHECK(named("a/wood.lin-rec2020.exr", linear) == "lin_rec2020");
    CHECK(named("wood_AdobeRGB.png", encoded) == "adobergb");
    CHECK(named("wood_display_p3_1k.png", encoded) == "displayp3");
    CHECK(named("sky_srgb.exr", linear) == "srgb");
    for (const char* name : {"wood.exr", "acescg/wood.exr", "wood_lin_rec709.exr", "linear_b.exr",
                             "aces.exr", "xyz.exr", ""}) {
        CAPTURE(name);
        CHECK(named(name, linear).empty());
    }
    CHECK(named("wood_srgb.png", encoded).empty());
}

TEST_CASE("metadata that an EXR cannot hold are left out, and said to be") {
    const std::string longest(31, 'a');
    Attributes attributes = {
        {"Artist", std::string("x")}, {longest, 1}, {longest + "a", 2}, {"", 3}, {"dataWindow", 4},
        {"a\nb" + longest, 5}};
    std::vector<std::string> notes;
    keepWhatFits(attributes, notes);
    CHECK(attributes.size() == 2);
    CHECK(attributes.contains(longest));
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].find('\n') == std::string::npos);
    CHECK(notes[0].ends_with(" and 1 more"));
    notes.clear();
    keepWhatFits(attributes, notes);
    CHECK(notes.empty());
}

TEST_CASE("quirks: alpha of formats whose reader says it wrongly") {
    OIIO::ImageSpec gif(2, 2, 4, OIIO::TypeUInt8);
    gif.alpha_channel = 4;
    CHECK(correctQuirks("gif", gif).empty());
    CHECK(gif.alpha_channel == 3);
    CHECK(gif.get_int_attribute("oiio:UnassociatedAlpha") == 1);
    OIIO::ImageSpec png(2, 2, 4, OIIO::TypeUInt8);
    CHECK(correctQuirks("png", png).empty());
    CHECK(png.get_int_attribute("oiio:UnassociatedAlpha") == 0);
    OIIO::ImageSpec webp(2, 2, 4, OIIO::TypeUInt8);
    CHECK(correctQuirks("webp", webp).size() == 1);
}

TEST_CASE("a description that contradicts itself is refused before a buffer is made") {
    const auto refused = [](auto change) {
        OIIO::ImageSpec spec(4, 3, 3, OIIO::TypeUInt8);
        change(spec);
        CHECK_THROWS_AS(checkConsistency("file", spec), FileError);
    };
    refused([](OIIO::ImageSpec& s) { s.width = 0; });
    refused([](OIIO::ImageSpec& s) { s.height = -3; });
    refused([](OIIO::ImageSpec& s) { s.width = kLargestSide + 1; });
    refused([](OIIO::ImageSpec& s) { s.nchannels = 0; });
    refused([](OIIO::ImageSpec& s) { s.nchannels = 1 << 20; });
    refused([](OIIO::ImageSpec& s) { s.tile_width = 64; });
    refused([](OIIO::ImageSpec& s) { s.tile_width = s.tile_height = -64; });
    refused([](OIIO::ImageSpec& s) { s.tile_width = 64, s.tile_height = 1 << 20; });
    refused([](OIIO::ImageSpec& s) { s.format = OIIO::TypeUnknown; });
    refused([](OIIO::ImageSpec& s) { s.deep = true; });
    refused([](OIIO::ImageSpec& s) { s.depth = 2; });
    OIIO::ImageSpec spec(4, 3, 4, OIIO::TypeUInt8);
    spec.alpha_channel = 4;
    checkConsistency("file", spec);
    CHECK(spec.alpha_channel == -1);
}
