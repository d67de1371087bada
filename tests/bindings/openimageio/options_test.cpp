#include "stand.h"

#include <specbake/core/table.h>
#include <specbake/image/measured_file.h>
#include <specbake/image/table_file.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

using namespace specbake;
using namespace specbake::testing;

TEST_CASE("options of a text file are those of a bake") {
    const Stand stand;
    const std::string source = "source = " + kImages + "rgba8.png\n";
    BakeOptions options;
    options.storage.tile = TileSize{7, 5};
    options.storage.mipmap = true;
    options.storage.sampleType = SampleType::float32;
    options.model.illuminant = "A";
    options.model.method = "smooth";
    options.model.outside = Outside::scale;
    checkSameImage(stand.recipe("a.spectral", "# wood\n" + source +
                                                  "tile = 7 5\n data-type=float\nilluminant = A\n"
                                                  "method = smooth\n\noutside = scale\r\n"),
                   stand.baked(kImages + "rgba8.png", options));
    BakeOptions few;
    few.bits = 6;
    few.color.space = "lin_rec709";
    few.read.channels = {"G"};
    few.model.grid = 9;
    checkSameImage(stand.recipe("b.spectral", source + "bits = 6\nspace = lin_rec709\n"
                                                       "channels = G\ngrid = 9\nmipmap = no\n"),
                   stand.baked(kImages + "rgba8.png", few));
    BakeOptions skin;
    skin.model.material = "skin";
    checkSameImage(stand.recipe("d.spectral", source + "material = skin\nmipmap = no\n"),
                   stand.baked(kImages + "rgba8.png", skin));
    BakeOptions fine;
    fine.model.quadrature = Quadrature::fine;
    checkSameImage(stand.recipe("e.spectral", source + "quadrature = fine\nmipmap = no\n"),
                   stand.baked(kImages + "rgba8.png", fine));
    BakeOptions measured;
    const std::string chart = SPECBAKE_SOURCE_DIR "/data/colorchecker_24.csv";
    measured.model.samples = readMeasuredFile(chart).samples;
    checkSameImage(stand.recipe("f.spectral", source + "mipmap = no\nsamples = " + chart + "\n"),
                   stand.baked(kImages + "rgba8.png", measured));
    BakeOptions chosen;
    chosen.maxDE = 0.3;
    chosen.maxDeviation = 0.01;
    chosen.read.part = "1";
    chosen.storage.mipmap = true;
    checkSameImage(
        stand.recipe("c.spectral", "source = " + kImages +
                                       "two_subimages.tif\nmax-de = 0.3\nmax-deviation = 0.01\n"
                                       "part = 1\n"),
        stand.baked(kImages + "two_subimages.tif", chosen));
}

TEST_CASE("other wavelengths, fewer and more, in every level") {
    const Stand stand;
    for (const char* nm : {"400:700:10", "360:830:5", "380:780:1", "400:720:3.2"}) {
        CAPTURE(nm);
        BakeOptions options;
        options.model.bands = parseWavelengths(nm);
        options.model.quadrature = Quadrature::fine;
        options.storage.mipmap = true;
        for (const char* texture : {"rgba8.png", "acescg_half.exr"}) {
            checkSameImage(stand.recipe("w.spectral", "source = " + kImages + texture +
                                                          "\nwavelengths = " + nm + "\n"),
                           stand.baked(kImages + texture, options));
        }
    }
}

namespace {

/// A table of a space with 9 nodes an axis, in a file.
void writeTable(const std::string& path, const char* space, Quadrature quadrature) {
    UpsamplerOptions options;
    options.grid = 9;
    options.quadrature = quadrature;
    const auto bytes = spectralTable(Upsampler(*findColorSpace(space), options)).bytes;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

std::string toldOf(const std::string& path) {
    CHECK(!OIIO::ImageInput::open(path));
    return OIIO::geterror();
}

}  // namespace

TEST_CASE("with a table, every texel has the spectrum that a renderer looks up") {
    const Stand stand;
    for (const Quadrature quadrature : kQuadratures) {
        writeTable(stand.path("t.spectab"), "lin_rec709", quadrature);
        const TableFile table = TableFile::read(stand.path("t.spectab"));
        const auto input =
            opened(stand.recipe("t.spectral", "source = " + kImages +
                                                  "rgba_half.exr\ntable = t.spectab\n"
                                                  "data-type = float\n"));
        const auto texture = opened(kImages + "rgba_half.exr");
        const OIIO::ImageSpec spec = input->spec(0, 0);
        REQUIRE(spec.nchannels == 85);
        CHECK(spec.get_string_attribute("specbake:table") == "t.spectab");
        CHECK(spec.get_int_attribute("specbake:grid") == 9);
        CHECK(spec.get_string_attribute("specbake:quadrature").empty() ==
              (quadrature == Quadrature::bands));
        std::vector<float> samples(spec.image_pixels() * 85);
        std::vector<float> colors(spec.image_pixels() * 4);
        REQUIRE(input->read_image(0, 0, 0, 85, OIIO::TypeFloat, samples.data()));
        REQUIRE(texture->read_image(0, 0, 0, 4, OIIO::TypeFloat, colors.data()));
        const Observer d65("D65", quadrature, {});
        const Imath::M33d rgb = xyzFromRGB(*findColorSpace("lin_rec709"), d65.white()).inverse();
        for (std::size_t i = 0; i < spec.image_pixels(); ++i) {
            const float a = colors[4 * i + 3];
            if (a == 0) continue;
            // OpenImageIO hands out colours that are multiplied by alpha.
            std::array<float, kBandCount> bands{};
            const auto at = [&](std::size_t c) { return colors[4 * i + c] / a; };
            table.view().evalBands(table.view().locate(at(0), at(1), at(2)), bands.data());
            Spectrum spectrum{};
            for (std::size_t m = 0; m < bands.size(); ++m) {
                // Two roundings of the colour, by the steepest slope of a grid, below 16.
                CHECK(std::abs(samples[85 * i + 4 + m] - bands[m]) <= 16 * 0x1p-22F);
                spectrum[m] = double(samples[85 * i + 4 + m]);
            }
            const Imath::V3d preview = d65.color(spectrum) * rgb;
            for (int c = 0; c < 3; ++c) {
                // 81 products of which the sum is 1: a rounding each.
                CHECK(std::abs(double(samples[85 * i + std::size_t(c)]) -
                               std::max(preview[c], 0.0)) < 100 * 0x1p-24);
            }
        }
        // Channels alone are the same, in every level.
        for (int level = 0; input->seek_subimage(0, level); ++level) {
            const std::size_t pixels = input->spec(0, level).image_pixels();
            std::vector<float> all(pixels * 85), some(pixels * 7);
            REQUIRE(input->read_image(0, level, 0, 85, OIIO::TypeFloat, all.data()));
            REQUIRE(input->read_image(0, level, 30, 37, OIIO::TypeFloat, some.data()));
            bool same = true;
            for (std::size_t i = 0; i < pixels * 7; ++i) {
                same = same && some[i] == all[i / 7 * 85 + 30 + i % 7];
            }
            CHECK(same);
        }
    }
}

TEST_CASE("a table of other colours, none, and options beside a table are refused") {
    const Stand stand;
    writeTable(stand.path("wide.spectab"), "acescg", Quadrature::bands);
    std::ofstream(stand.path("no.spectab")) << "no table";
    const std::string source = "source = " + kImages + "rgb8.png\ntable = ";
    const auto told = [&](const std::string& rest) {
        return toldOf(stand.recipe("t.spectral", source + rest));
    };
    CHECK(told("wide.spectab\n").find("acescg") != std::string::npos);
    CHECK(told("absent.spectab\n").find("absent.spectab") != std::string::npos);
    CHECK(told("no.spectab\n").find("no table of spectra") != std::string::npos);
    CHECK(told("wide.spectab\nmethod = natural\n").find("'method'") != std::string::npos);
}

TEST_CASE("hints of the host override the text file") {
    const Stand stand;
    BakeOptions options;
    options.model.illuminant = "F2";
    options.storage.mipmap = true;
    const std::string baked = stand.baked(kImages + "rgb8.png", options);
    OIIO::ImageSpec config;
    config.attribute("spectral:illuminant", "F2");
    const auto ours = OIIO::ImageInput::open(kImages + "rgb8.png.spectral", &config);
    REQUIRE(ours);
    CHECK(samplesOf(*ours, 0, 0, 84) == samplesOf(*opened(baked), 0, 0, 84));
}
