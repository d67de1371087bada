#include "texture/color/icc_profile.h"

#include "support/icc_file.h"
#include "texture/color/png_signs.h"

#include <specbake/core/adaptation.h>
#include <specbake/core/ciede2000.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

const XYZ kD50(0.9642, 1.0, 0.8249);  // ICC.1, 7.2.16

/// Of s15Fixed16Number, by which profiles count.
constexpr double kFixed = 0x1p-17;

ColorMeaning meaningOf(const std::string& bytes, ColorModel model = ColorModel::rgb,
                       int channels = 3) {
    return meaningOfProfile(bytes, model, channels);
}

/// A press that no one has: L falls with each ink, a and b are hues of its own.
Lab press(const float* ink) {
    const double light = (1 - 0.5 * double(ink[0])) * (1 - 0.5 * double(ink[1])) *
                         (1 - 0.1 * double(ink[2])) * (1 - 0.9 * double(ink[3]));
    const double tint = 1 - double(ink[3]);
    return {100 * light, tint * (60 * double(ink[1]) - 30 * double(ink[0])),
            tint * (70 * double(ink[2]) - 40 * double(ink[0]))};
}

Lab scanner(const float* rgb) {
    return {100 * (0.3 * double(rgb[0]) + 0.6 * double(rgb[1]) + 0.1 * double(rgb[2])),
            60 * (double(rgb[0]) - double(rgb[1])), 70 * (double(rgb[1]) - double(rgb[2]))};
}

Lab labOf(const std::array<float, 3>& linear) {
    const auto at = [&](std::size_t i) { return double(linear[i]); };
    const Imath::V3d rgb(at(0), at(1), at(2));
    return labFromXYZ(XYZ(rgb * xyzFromRGB(*findColorSpace("lin_prophoto"), kD50)), kD50);
}

bool isFinite(const ColorMeaning& meaning, std::size_t channels) {
    bool finite = true;
    if (meaning.curves) {
        for (const auto& curve : *meaning.curves) {
            finite &=
                curve.size() == kCurveSize &&
                std::all_of(curve.begin(), curve.end(), [](float v) { return std::isfinite(v); });
        }
    }
    if (meaning.transform) {
        std::vector<float> pixels;
        for (std::size_t i = 0; i < 16 * channels; ++i) pixels.push_back(float(i % 7) / 6);
        std::vector<std::array<float, 3>> linear(16);
        meaning.transform->run(pixels.data(), 16, linear.data());
        for (const auto& color : linear) {
            finite &=
                std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
        }
    }
    return finite;
}

}  // namespace

TEST_CASE("a profile of a matrix is its primaries, its white and its curves") {
    const Primaries own{{0.62, 0.34}, {0.27, 0.63}, {0.14, 0.07}, {0.30, 0.32}};
    const ColorMeaning meaning = meaningOf(matrixProfile(own, 1.7));
    CHECK(meaning.source == ColorSource::icc);
    CHECK(meaning.space.name == "icc");
    CHECK(meaning.profile.size() == 16);
    REQUIRE(meaning.space.primaries);
    const Primaries& there = *meaning.space.primaries;
    // Colorants of about 1/2, each to half of 2^-16, whose sum divides them; and chad's nine.
    constexpr double tolerance = 40 * kFixed;
    for (const auto& [a, b] :
         {std::pair(own.red, there.red), std::pair(own.green, there.green),
          std::pair(own.blue, there.blue), std::pair(own.white, there.white)}) {
        CHECK(std::abs(a.x - b.x) < tolerance);
        CHECK(std::abs(a.y - b.y) < tolerance);
    }
    REQUIRE(meaning.curves);
    for (const int code : {0, 1, 100, 30000, 65535}) {
        const auto i = std::size_t(code);
        const double expected = std::pow(double(i) / 65535, 1.7);
        CHECK(std::abs(double((*meaning.curves)[1][i]) - expected) < 1e-5);  // 1.7 to 2^-17
    }
}

TEST_CASE("profiles of known spaces are these: a name, and no curves of their own") {
    int known = 0;
    for (const ColorSpace& space : colorSpaces()) {
        const bool power = space.transfer == Transfer::power(space.transfer.gamma);
        if (space.isXYZ() || !power || space.primaries->blue.y < 0) continue;
        CAPTURE(space.name);
        const ColorMeaning meaning =
            meaningOf(matrixProfile(*space.primaries, space.transfer.gamma));
        CHECK(meaning.space.name == space.name);
        CHECK(meaning.curves == nullptr);
        CHECK(meaning.profile.empty());
        ++known;
    }
    CHECK(known >= 12);
}

TEST_CASE("grey is neutral, by its curve") {
    const ColorMeaning meaning = meaningOf(greyProfile(1.5), ColorModel::rgb, 1);
    CHECK(meaning.space.name == "lin_rec709");
    REQUIRE(meaning.curves);
    for (const int code : {0, 1000, 65535}) {
        const auto i = std::size_t(code);
        const double expected = std::pow(double(i) / 65535, 1.5);
        for (const auto& curve : *meaning.curves) {
            CHECK(std::abs(double(curve[i]) - expected) < 1e-5);
        }
    }
    CHECK_THROWS_AS(meaningOf(greyProfile(1.5)), ProfileError);  // for three channels
}

TEST_CASE("tables give the colours of their nodes, and paper is white") {
    const unsigned grid = 5;
    const std::string inks = tableProfile(cmsSigCmykData, grid, press);
    const ColorMeaning meaning = meaningOf(inks, ColorModel::cmyk, 4);
    const ColorMeaning left = meaningOf(inks, ColorModel::cmykOnPaper, 4);
    CHECK(meaning.space.name == "lin_prophoto");
    REQUIRE(meaning.transform);
    std::array<float, 4> ink{};
    for (unsigned node = 0; node < grid * grid * grid * grid; ++node) {
        unsigned rest = node;
        for (float& amount : ink) {
            amount = float(rest % grid) / float(grid - 1);
            rest /= grid;
        }
        std::array<float, 3> linear{};
        meaning.transform->run(ink.data(), 1, &linear);
        // Half a step of 16 bits is 100 / 131070 of L and 255 / 131070 of a and b; CIEDE2000 is at
        // most the distance in Lab, but for the factor of 1.5 on a near grey, and white is made
        // good by up to as much again.
        constexpr double tolerance = 2 * 1.5 * 255.0 / 131070 * 1.7321;
        CHECK(ciede2000(labOf(linear), press(ink.data())) < tolerance);
        std::array<float, 4> paper{};
        for (std::size_t i = 0; i < 4; ++i) paper[i] = 1 - ink[i];
        std::array<float, 3> same{};
        left.transform->run(paper.data(), 1, &same);
        CHECK(same == linear);
    }
    const std::array<float, 4> none{};
    std::array<float, 3> white{};
    meaning.transform->run(none.data(), 1, &white);
    for (const float component : white) CHECK(std::abs(component - 1) < 1e-6F);
    const ColorMeaning rgb = meaningOf(tableProfile(cmsSigRgbData, 9, scanner));
    REQUIRE(rgb.transform);
    const std::array<float, 3> node = {0.25F, 0.5F, 0.375F};
    std::array<float, 3> linear{};
    rgb.transform->run(node.data(), 1, &linear);
    CHECK(ciede2000(labOf(linear), scanner(node.data())) < 0.02);
}

TEST_CASE("runs of pixels are what each pixel is by itself") {
    const ColorMeaning meaning = meaningOf(tableProfile(cmsSigRgbData, 5, scanner));
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> pixels(3 * 1000);
    for (float& value : pixels) value = uniform(random);
    std::vector<std::array<float, 3>> together(1000);
    meaning.transform->run(pixels.data(), together.size(), together.data());
    for (std::size_t i = 0; i < together.size(); ++i) {
        std::array<float, 3> alone{};
        meaning.transform->run(&pixels[3 * i], 1, &alone);
        CHECK(alone == together[i]);
    }
}

TEST_CASE("what is no profile, or one of no image, is refused in a line") {
    for (const std::string& bytes :
         {std::string(), std::string("x"), std::string(128, '\0'), std::string(1 << 20, 'x'),
          std::string(kLargestProfile + 1, 'x')}) {
        try {
            static_cast<void>(meaningOf(bytes));
            FAIL("a profile of nothing");
        } catch (const ProfileError& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
            CHECK_FALSE(std::string(error.what()).empty());
        }
    }
    CHECK_THROWS_AS(meaningOf(tableProfile(cmsSigCmykData, 3, press)), ProfileError);
    const std::string good = matrixProfile(*findColorSpace("srgb")->primaries, 2.2);
    CHECK_THROWS_AS(meaningOf(good, ColorModel::cmyk, 4), ProfileError);
    std::string link = good;
    link.replace(12, 4, "link");
    CHECK_THROWS_AS(meaningOf(link), ProfileError);
}

TEST_CASE("damaged profiles: refused, or of finite numbers") {
    struct Kind {
        std::string bytes;
        ColorModel model;
        int channels;
    };
    const Kind kinds[] = {
        {matrixProfile(*findColorSpace("displayp3")->primaries, 1.9), ColorModel::rgb, 3},
        {greyProfile(1.4), ColorModel::rgb, 1},
        {tableProfile(cmsSigRgbData, 5, scanner), ColorModel::rgb, 3},
        {tableProfile(cmsSigCmykData, 3, press), ColorModel::cmyk, 4}};
    std::mt19937 random(3);
    const auto below = [&](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    const auto check = [](const Kind& kind, const std::string& bytes) {
        try {
            const ColorMeaning meaning = meaningOfProfile(bytes, kind.model, kind.channels);
            CHECK(isFinite(meaning, std::size_t(kind.channels)));
            return true;
        } catch (const ProfileError& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
            return false;
        }
    };
    for (const Kind& kind : kinds) {
        CHECK(check(kind, kind.bytes));
        for (std::size_t i = 0; i < 100; ++i) {
            check(kind, kind.bytes.substr(0, kind.bytes.size() * i / 100));
        }
        // The header and the tags are where damage leads astray.
        const std::size_t head = std::min<std::size_t>(kind.bytes.size(), 600);
        for (int i = 0; i < 400; ++i) {
            std::string bytes = kind.bytes;
            const std::size_t end = i % 2 == 0 ? head : bytes.size();
            for (std::size_t n = 1 + below(4); n > 0; --n) bytes[below(end)] = char(below(256));
            check(kind, bytes);
        }
    }
}
