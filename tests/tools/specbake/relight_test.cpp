#include "process.h"
#include "read_back.h"

#include <specbake/core/adaptation.h>
#include <specbake/core/observer.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace specbake;
using namespace specbake::testing;

namespace {

using Names = std::vector<std::string>;

/// The spectral image of a test image, in a folder of its own.
struct Spectral {
    Scratch scratch;
    std::string path;

    explicit Spectral(const std::string& image, const char* type = "float")
        : path(scratch.path("s.exr")) {
        REQUIRE(runTool({"bake", "-q", testImage(image), "-o", path, "-d", type}).exitCode == 0);
    }

    ReadBack relit(const std::string& name, Names options) const {
        options.insert(options.begin(), {"relight", path, "-o", scratch.path(name)});
        const Outcome outcome = runTool(options);
        CHECK(outcome.err == "");
        REQUIRE(outcome.exitCode == 0);
        CHECK(scratch.names().size() == 2);
        const ReadBack picture(scratch.path(name));
        std::filesystem::remove(scratch.path(name));
        return picture;
    }
};

/// R, G, B of linear Rec.709 under a light, by (1) and the definitions.
RGB shownUnder(const std::string& illuminant, bool adapt, const std::array<float, 81>& bands) {
    Spectrum reflectance;
    std::copy(bands.begin(), bands.end(), reflectance.begin());
    const Observer observer(illuminant);
    const XYZ daylight = Observer("D65").white();
    XYZ color = observer.color(reflectance);
    if (adapt) color = XYZ(color * adaptation(observer.white(), daylight));
    return RGB(color * xyzFromRGB(*findColorSpace("lin_rec709"), daylight).inverse());
}

constexpr double kFloat = 1e-5;  // 81 float products of at most 3, and their sum, at 2⁻²⁴ each

void checkTexel(const ReadBack& picture, int x, int y, const RGB& expected) {
    CHECK(std::abs(double(picture.at(x, y, "R")) - expected.x) < kFloat);
    CHECK(std::abs(double(picture.at(x, y, "G")) - expected.y) < kFloat);
    CHECK(std::abs(double(picture.at(x, y, "B")) - expected.z) < kFloat);
}

}  // namespace

TEST_SUITE_BEGIN("relight");

TEST_CASE("under the light that it was baked for, an 8-bit texture comes back as it was") {
    // Half is within 2⁻¹² of linear v; d(code)/dv · 2⁻¹² v is 255/2.4 · 2⁻¹² v^(1/2.4) < 0.03, and
    // below the curve's knee 255 · 12.92 · 2⁻¹² · 0.0031 < 0.003: far from half a code.
    const ReadBack texture(testImage("rgb8.png"));
    const ReadBack picture = Spectral("rgb8.png", "half").relit("p.png", {"--illuminant", "D65"});
    CHECK(picture.spec.format == OIIO::TypeUInt8);
    CHECK(picture.samples == texture.samples);
}

TEST_CASE("under another light it is what the definitions say") {
    const Spectral spectral("rgb_float.exr");
    const ReadBack bands(spectral.path);
    const ReadBack adapted = spectral.relit("p.exr", {"--illuminant", "A"});
    const ReadBack tinted = spectral.relit("p.exr", {"--illuminant", "F11", "--no-adapt"});
    const ReadBack brighter = spectral.relit("p.exr", {"--illuminant", "A", "--exposure", "1"});
    CHECK(adapted.spec.format == OIIO::TypeFloat);
    std::array<float, 81> white{};
    white.fill(1.0F);
    const RGB tint = shownUnder("F11", false, white);
    const double largest = std::max({tint.x, tint.y, tint.z});
    for (const int y : {0, 7, 15}) {
        for (int x = 0; x < bands.spec.width; ++x) {
            const auto spectrum = bands.bands(x, y);
            const RGB expected = shownUnder("A", true, spectrum);
            checkTexel(adapted, x, y, expected);
            checkTexel(brighter, x, y, RGB(expected * 2.0));
            checkTexel(tinted, x, y, RGB(shownUnder("F11", false, spectrum) / largest));
        }
    }
    checkTexel(adapted, 0, 0, RGB(1, 1, 1));
    CHECK(tint.x > tint.y);  // F11 is warmer than D65
    CHECK(tint.y > tint.z);
}

TEST_CASE("under several lights the pictures of each are side by side") {
    const Spectral spectral("offset.exr");
    const Names lights = {"D65", "F11", "LED-B1"};
    const ReadBack all = spectral.relit("p.exr", {"--illuminant", "D65,F11,LED-B1"});
    const int width = all.spec.width / 3;
    CHECK(std::array{all.spec.x, all.spec.y, all.spec.width, all.spec.height} ==
          std::array{0, 0, 3 * 24, 16});
    for (int i = 0; i < 3; ++i) {
        const ReadBack one = spectral.relit("p.exr", {"--illuminant", lights[std::size_t(i)]});
        REQUIRE(one.spec.width == width);
        int equal = 0;
        for (int y = 0; y < all.spec.height; ++y) {
            for (int x = 0; x < width; ++x) {
                for (const char* c : {"R", "G", "B"}) {
                    equal += one.at(x, y, c) == all.at(i * width + x, y, c) ? 1 : 0;
                }
            }
        }
        CHECK(equal == 3 * width * all.spec.height);
    }
}

TEST_CASE("alpha goes into the picture as its format has it") {
    const Spectral spectral("rgba8.png");
    const ReadBack texture(testImage("rgba8.png"));
    const ReadBack png = spectral.relit("p.png", {"--illuminant", "D65"});
    CHECK(png.samples == texture.samples);
    const ReadBack exr = spectral.relit("p.exr", {"--illuminant", "D65"});
    const double linear = linearFromSRGB(double(texture.at(9, 2, "R")));
    const float alpha = texture.at(9, 2, "A");
    REQUIRE(alpha == doctest::Approx(0.6));
    CHECK(exr.at(9, 2, "A") == alpha);
    CHECK(std::abs(double(exr.at(9, 2, "R")) - linear * double(alpha)) < kFloat);
    CHECK(spectral.relit("p.jpg", {}).spec.nchannels == 3);
}

TEST_CASE("windows are kept where the format has them") {
    const Spectral spectral("offset.exr");
    const OIIO::ImageSpec exr = spectral.relit("p.exr", {}).spec;
    CHECK(std::array{exr.x, exr.y, exr.width, exr.height} == std::array{-7, 5, 24, 16});
    CHECK(std::array{exr.full_x, exr.full_y, exr.full_width, exr.full_height} ==
          std::array{-10, -20, 64, 48});
    const OIIO::ImageSpec png = spectral.relit("p.png", {}).spec;
    CHECK(std::array{png.x, png.y, png.width, png.height} == std::array{0, 0, 24, 16});
}

TEST_CASE("what cannot be relit is refused, and nothing is left behind") {
    const Spectral spectral("1x1.png");
    const auto refused = [&](const Names& arguments, int exitCode) {
        const Outcome outcome = runTool(arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.exitCode == exitCode);
        CHECK(linesOf(outcome.err).size() == 1);
        CHECK(spectral.scratch.names() == Names{"s.exr"});
    };
    const std::string picture = spectral.scratch.path("p.png");
    refused({"relight", testImage("rgb8.png"), "-o", picture}, 1);
    refused({"relight", spectral.path, "-o", spectral.scratch.path("p.unknown")}, 1);
    refused({"relight", spectral.path, "-o", spectral.scratch.path("absent/p.png")}, 1);
    refused({"relight", spectral.path, "-o", spectral.path}, 2);
    refused({"relight", spectral.path, "-o", picture, "--illuminant", "Z"}, 2);
}

TEST_SUITE_END();
