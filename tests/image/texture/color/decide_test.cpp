#include "texture/color/decide.h"

#include "support/icc_file.h"

#include <specbake/core/error.h>
#include <specbake/image/texture.h>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

/// 8-bit RGB of which the file says nothing.
ImageDescription silent() {
    ImageDescription image;
    image.data = image.display = {0, 0, 2, 2};
    image.channels = {"R", "G", "B"};
    return image;
}

ImageDescription floats() {
    ImageDescription image = silent();
    image.integers = false;
    image.sampleType = TexelType::half;
    return image;
}

Primaries primariesOf(const char* space) {
    return *findColorSpace(space)->primaries;
}

ColorMeaning meaning(const ImageDescription& image) {
    std::vector<std::string> notes;
    return meaningOf(image, notes);
}

std::vector<std::string> notesOn(const ImageDescription& image) {
    std::vector<std::string> notes;
    static_cast<void>(meaningOf(image, notes));
    return notes;
}

std::string space(const ImageDescription& image) {
    return meaning(image).space.name;
}

}  // namespace

TEST_CASE("what a file says comes in the order of the PNG specification: all 32 combinations") {
    const std::string adobe = matrixProfile(primariesOf("adobergb"), 563.0 / 256);
    for (unsigned all = 0; all < 32; ++all) {
        CAPTURE(all);
        ImageDescription image = silent();
        if (all & 1) image.signs.cicp = CodePoints{12, 13, 0, true};
        if (all & 2) image.signs.icc = adobe;
        if (all & 4) image.signs.srgb = true;
        if (all & 8) image.signs.gamma = 1 / 1.8;
        if (all & 16) image.signs.chromaticities = primariesOf("rec2020");
        const ColorMeaning m = meaning(image);
        // PNG, third edition, 4.3: cICP, then iCCP, then sRGB, then gAMA and cHRM.
        if (all & 1) {
            CHECK(m.source == ColorSource::cicp);
            CHECK(m.space.name == "displayp3");
        } else if (all & 2) {
            CHECK(m.source == ColorSource::icc);
            CHECK(m.space.name == "adobergb");
        } else if (all & 4) {
            CHECK(m.source == ColorSource::srgbChunk);
            CHECK(m.space.name == "srgb");
        } else if (all & 8) {
            CHECK(m.source == ColorSource::gamma);
            CHECK(std::abs(m.space.transfer.gamma - 1.8) < 1e-12);
            CHECK(m.space.primaries == primariesOf(all & 16 ? "rec2020" : "srgb"));
        } else if (all & 16) {
            CHECK(m.source == ColorSource::chromaticities);
            CHECK(m.space.primaries == primariesOf("rec2020"));
            CHECK(m.space.transfer == Transfer::sRGB);
        } else {
            CHECK(m.source == ColorSource::sampleType);
            CHECK(m.space.name == "srgb");
        }
        CHECK_FALSE(m.reason.empty());
        CHECK(m.problem.empty());
    }
}

TEST_CASE("gAMA: 1.0 is linear, 45455 is what writers of sRGB put there") {
    ImageDescription image = silent();
    image.signs.gamma = 1.0;
    CHECK(space(image) == "lin_rec709");
    image.signs.gamma = 0.45455;
    CHECK(space(image) == "srgb");
    image.signs.gamma = 1 / 2.2;
    CHECK(space(image) == "srgb");
    image.signs.gamma = 0.45;
    CHECK(std::abs(meaning(image).space.transfer.gamma - 1 / 0.45) < 1e-12);
    image.signs.chromaticities = primariesOf("displayp3");
    image.signs.gamma = 0.45455;
    CHECK(space(image) == "displayp3");
}

TEST_CASE("floats are linear by default, by chromaticities too; X, Y, Z are XYZ") {
    ImageDescription image = floats();
    CHECK(space(image) == "lin_rec709");
    image.signs.chromaticities = primariesOf("acescg");
    CHECK(space(image) == "acescg");
    CHECK(meaning(image).source == ColorSource::chromaticities);
    image.channels = {"x", "Y", "Z"};
    CHECK(space(image) == "xyz");
    CHECK(meaning(image).source == ColorSource::channels);
    // Integers of 32 bits come as floats, and are encoded all the same.
    image = floats();
    image.integers = true;
    CHECK(space(image) == "srgb");
    image.signs.chromaticities = primariesOf("displayp3");
    CHECK(space(image) == "displayp3");
}

TEST_CASE("what cannot be used is left aside for what comes next, and a line says why") {
    ImageDescription image = silent();
    image.signs.icc = "no profile";
    CHECK(space(image) == "srgb");
    REQUIRE(notesOn(image).size() == 1);
    CHECK(notesOn(image)[0].find("its ICC profile is not used: ") == 0);
    image.signs.gamma = 1.0;
    CHECK(space(image) == "lin_rec709");

    image = silent();
    image.signs.cicp = CodePoints{2, 2, 0, true};  // "unspecified"
    CHECK(space(image) == "srgb");
    CHECK(notesOn(image).size() == 1);
    image.signs.cicp = CodePoints{1, 13, 1, true};  // Y'CbCr, which no PNG holds
    CHECK(notesOn(image).size() == 1);
    image.signs.cicp = CodePoints{1, 13, 0, false};  // narrow range
    CHECK(notesOn(image).size() == 1);

    image = floats();
    image.signs.chromaticities = Primaries{{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    CHECK(space(image) == "lin_rec709");
    CHECK(notesOn(image).size() == 1);

    image = silent();
    image.signs.srgb = true;
    image.signs.gamma = 1.0;
    image.signs.chromaticities = primariesOf("displayp3");
    CHECK(space(image) == "srgb");
    CHECK(notesOn(image).size() == 2);
    image.signs.gamma = 0.45455;
    image.signs.chromaticities = primariesOf("srgb");
    CHECK(notesOn(image).empty());
}

TEST_CASE("a profile of other colours than the image's is not used") {
    ImageDescription image = silent();
    image.channels = {"C", "M", "Y", "K"};
    image.signs.model = ColorModel::cmyk;
    image.signs.icc = matrixProfile(primariesOf("srgb"), 2.2);
    CHECK(notesOn(image).size() == 2);  // not used, and so the inks are guessed at
    CHECK(meaning(image).transform != nullptr);
}

TEST_CASE("code points of H.273: the spaces that they name") {
    const auto named = [](int primaries, int transfer) {
        ImageDescription image = silent();
        image.signs.cicp = CodePoints{primaries, transfer, 0, true};
        return space(image);
    };
    CHECK(named(1, 13) == "srgb");
    CHECK(named(1, 1) == "rec709");
    CHECK(named(1, 6) == "rec709");
    CHECK(named(1, 4) == "g22_rec709");
    CHECK(named(1, 8) == "lin_rec709");
    CHECK(named(9, 14) == "rec2020");
    CHECK(named(9, 15) == "rec2020");
    CHECK(named(9, 8) == "lin_rec2020");
    CHECK(named(12, 13) == "displayp3");
    CHECK(named(11, 8) == "lin_dcip3");
    CHECK(named(5, 13) == "custom");
    for (const int transfer : {16, 18}) {  // PQ, HLG
        ImageDescription image = silent();
        image.signs.cicp = CodePoints{9, transfer, 0, true};
        CHECK(meaning(image).problem.find("--space") != std::string::npos);
    }
}

TEST_CASE("users come first, and are told what they overrule") {
    TextureInfo texture;
    texture.path = "a.png";
    ImageDescription image = silent();
    image.signs.srgb = true;
    texture.color = meaning(image);
    std::vector<std::string> unused;
    const auto chosen = [&](const ColorWishes& wishes) {
        unused.clear();
        return chosenMeaning(texture, wishes, unused);
    };
    CHECK(chosen({}).source == ColorSource::srgbChunk);
    CHECK(unused.empty());
    const ColorMeaning p3 = chosen({.space = "Display P3", .transfer = {}, .primaries = {}});
    CHECK(p3.space.name == "displayp3");
    CHECK(p3.source == ColorSource::user);
    CHECK(unused.size() == 1);
    CHECK(chosen({.space = {}, .transfer = "gamma:2.2", .primaries = {}}).space.name ==
          "g22_rec709");
    CHECK(chosen({.space = {}, .transfer = {}, .primaries = "adobergb"}).space.primaries ==
          primariesOf("adobergb"));
    CHECK(chosen({.space = "xyz", .transfer = {}, .primaries = {}}).space.isXYZ());
    CHECK_THROWS_AS(chosen({.space = "xyz", .transfer = "srgb", .primaries = {}}), ArgumentError);
    CHECK_THROWS_AS(chosen({.space = "nonsense", .transfer = {}, .primaries = {}}), ArgumentError);
    // What is no reflectance is refused, unless the user says that it is.
    image.signs = {};
    image.signs.cicp = CodePoints{9, 16, 0, true};
    texture.color = meaning(image);
    CHECK_THROWS_AS(chosen({}), FileError);
    CHECK(chosen({.space = "rec2020", .transfer = {}, .primaries = {}}).space.name == "rec2020");
}
