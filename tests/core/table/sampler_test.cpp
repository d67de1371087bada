#include "shader_lookup.h"

#include <specbake/core/table.h>
#include <specbake/sampler.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

using namespace specbake;

namespace {

using Color = std::array<float, 3>;
using Bytes = std::vector<std::byte>;

UpsamplerOptions withGrid(int nodes) {
    UpsamplerOptions options;
    options.grid = nodes;
    return options;
}

/// A small table of sRGB, and the model that it was made of.
struct Stand {
    Upsampler upsampler{*findColorSpace("srgb"), withGrid(6)};
    Bytes bytes = spectralTable(upsampler).bytes;
    SpectralTable table = viewOf(bytes);

    static SpectralTable viewOf(const Bytes& bytes) {
        SpectralTable table;
        REQUIRE(table.view(bytes.data(), bytes.size()) == SpectralTable::Status::ok);
        return table;
    }
};

/// Seeded colours, corners, edges and faces of the cube and what is beyond among them.
std::vector<Color> colors() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> component(-0.3F, 1.3F);
    std::vector<Color> all;
    for (int i = 0; i < 5000; ++i) {
        Color color{component(random), component(random), component(random)};
        if (random() % 3 == 0) color[random() % 3] = float(random() % 2);
        if (random() % 5 == 0) color[1] = color[0];
        if (random() % 5 == 0) color[2] = color[1];
        all.push_back(color);
    }
    return all;
}

Color clamped(Color color) {
    for (float& c : color) c = std::clamp(c, 0.0F, 1.0F);
    return color;
}

}  // namespace

TEST_CASE("a table gives the model's spectra to half a step of its samples") {
    const Stand stand;
    double worst = 0;
    for (const Color& color : colors()) {
        const Color inside = clamped(color);
        const auto expected = stand.upsampler.sample({&inside, 1}, SampleSelection::bands());
        std::array<float, kBandCount> bands;
        stand.table.evalBands(stand.table.locate(color[0], color[1], color[2]), bands.data());
        for (std::size_t m = 0; m < bands.size(); ++m) {
            worst = std::max(worst, std::abs(double(bands[m]) - double(expected[m])));
        }
    }
    // A convex combination of samples, each within half a step, and floats' roundings near 1.
    CHECK(worst <= 0.5 / 65535 + 16 * 0x1p-24);
}

TEST_CASE("between bands reflectance is linear, beyond them it is theirs, whatever N") {
    const Stand stand;
    std::mt19937 random(6);
    std::uniform_real_distribution<float> anywhere(300.0F, 900.0F);
    double worst = 0;
    for (const Color& color : colors()) {
        const auto place = stand.table.locate(color[0], color[1], color[2]);
        std::array<float, kBandCount> bands;
        stand.table.evalBands(place, bands.data());
        std::array<float, 13> nm;
        for (float& w : nm)
            w = random() % 4 == 0 ? float(380 + 5 * (random() % 81)) : anywhere(random);
        std::array<float, 13> got;
        stand.table.eval(place, stand.table.wavelengths<13>(nm), got.data());
        for (std::size_t i = 0; i < nm.size(); ++i) {
            const double band = std::clamp((double(nm[i]) - 380) / 5, 0.0, 80.0);
            const auto below = std::size_t(std::min(band, 79.0));
            const double f = band - double(below);
            const double expected = (1 - f) * double(bands[below]) + f * double(bands[below + 1]);
            worst = std::max(worst, std::abs(double(got[i]) - expected));
            worst = std::max(worst, std::abs(double(stand.table.eval(place, nm[i])) - expected));
        }
    }
    // The paths differ by 1e-6; a wavelength in float is off by 900 · 2^-24 nm, of 5 nm a band.
    CHECK(worst <= 1e-6 + 900 * 0x1p-23 / 5);
}

TEST_CASE("NaN is black's component, black is 0 and white is 1") {
    const Stand stand;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::array<float, kBandCount> bands;
    const auto allAre = [&](float r, float g, float b, double value) {
        stand.table.evalBands(stand.table.locate(r, g, b), bands.data());
        return std::all_of(bands.begin(), bands.end(), [&](float band) {
            return std::abs(double(band) - value) <= 2 * 0x1p-24;
        });
    };
    CHECK(allAre(0, 0, 0, 0));
    CHECK(allAre(nan, nan, nan, 0));
    CHECK(allAre(-1, nan, -infinity, 0));
    CHECK(allAre(1, 1, 1, 1));
    CHECK(allAre(infinity, 2, 1, 1));
    const auto place = stand.table.locate(0.5F, 0.5F, 0.5F);
    CHECK(stand.table.eval(place, nan) == stand.table.eval(place, 380));
}

TEST_CASE("the arithmetic that the docs give for shaders gives the header's reflectance") {
    const Stand stand;
    const testing::ShaderTable shader(stand.bytes);
    double worst = 0;
    for (const Color& color : colors()) {
        const auto place = stand.table.locate(color[0], color[1], color[2]);
        for (const float nm : {380.0F, 401.3F, 555.5F, 777.0F, 780.0F}) {
            const double expected = double(stand.table.eval(place, nm));
            worst = std::max(worst, std::abs(double(shader.reflectance(color, nm)) - expected));
        }
    }
    CHECK(worst <= 1e-6);
}

TEST_CASE("damaged bytes are refused, or read within their bounds") {
    const Stand stand;
    CHECK(stand.table.intact());
    for (std::size_t size = 0; size < stand.bytes.size(); size += size < 300 ? 1 : 9973) {
        const Bytes cut(stand.bytes.begin(), stand.bytes.begin() + std::ptrdiff_t(size));
        SpectralTable table;
        CHECK(table.view(cut.data(), cut.size()) != SpectralTable::Status::ok);
    }
    std::mt19937 random(7);
    for (int i = 0; i < 20'000; ++i) {
        Bytes damaged(stand.bytes.begin(), stand.bytes.begin() + 4096);
        const bool whole = random() % 8 == 0;
        if (whole) damaged = stand.bytes;
        const std::size_t at = random() % 256;
        damaged[at] ^= std::byte(1 + random() % 255);
        SpectralTable table;
        if (table.view(damaged.data(), damaged.size()) != SpectralTable::Status::ok) continue;
        CHECK_FALSE(table.intact());
        std::vector<float> bands(table.header().bands);
        table.evalBands(table.locate(0.9F, 1, 0.2F), bands.data());
        CHECK(std::isfinite(table.eval(table.locate(1, 1, 1), 780)));
    }
}

TEST_CASE("a changed byte anywhere shows in the checksum") {
    const Stand stand;
    std::mt19937 random(8);
    for (int i = 0; i < 100; ++i) {
        Bytes damaged = stand.bytes;
        damaged[SpectralTableHeader::kChecked + random() % (damaged.size() - 300)] ^= std::byte(1);
        SpectralTable table;
        if (table.view(damaged.data(), damaged.size()) == SpectralTable::Status::ok) {
            CHECK_FALSE(table.intact());
        }
    }
    // ISO 3309's published check value.
    const std::array<unsigned char, 9> digits = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    CHECK(SpectralTable::crc32(digits.data(), digits.size()) == 0xCBF43926U);
}
