#include "support/contents.h"

#include <specbake/bake/bake.h>
#include <specbake/core/error.h>
#include <specbake/core/upsampler.h>
#include <specbake/image/memory_texture.h>
#include <specbake/image/texture_reader.h>

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

using namespace specbake;
using specbake::testing::contentsOf;

namespace {

const std::string kImages = std::string(SPECBAKE_SOURCE_DIR) + "/testimages/";

/// RGB and alpha of seeded texels, floats.
std::vector<float> texels(int count) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> values(std::size_t(count) * 4);
    for (float& value : values) value = uniform(random);
    return values;
}

MemoryImage imageOf(const std::vector<float>& values, int width, int height) {
    MemoryImage image;
    image.width = width;
    image.height = height;
    image.channels = 4;
    image.alpha = 3;
    image.attributes.emplace("Artist", std::string("nobody"));
    image.samples = std::as_bytes(std::span(values));
    return image;
}

struct Rows {
    SpectralHeader header;
    std::vector<std::vector<float>> rows;

    RowReceiver receiver() {
        return {[this](const SpectralHeader& h) { header = h; },
                [this](int row, std::span<const std::byte> samples) {
                    CHECK(row == int(rows.size()));
                    std::vector<float>& values = rows.emplace_back(samples.size() / sizeof(float));
                    std::memcpy(values.data(), samples.data(), samples.size());
                }};
    }
};

}  // namespace

TEST_CASE("an array becomes rows of spectra without a file") {
    const auto values = texels(37 * 21);
    MemoryTexture texture(imageOf(values, 37, 21));
    BakeOptions options;
    options.storage.sampleType = SampleType::float32;
    Rows taken;
    const BakeStatistics statistics = bake(texture, taken.receiver(), options);
    CHECK(statistics.texels == 37 * 21);
    CHECK(taken.header.alpha);
    CHECK(std::get<std::string>(taken.header.attributes.at("Artist")) == "nobody");
    CHECK(std::get<std::string>(taken.header.attributes.at("specbake:illuminant")) == "D65");
    REQUIRE(taken.rows.size() == 21);

    // The model itself, asked colour by colour.
    const Upsampler upsampler(*findColorSpace("lin_rec709"));
    std::size_t differences = 0;
    for (std::size_t t = 0; t < 37 * 21; ++t) {
        const Upsampler::Color color = {values[4 * t], values[4 * t + 1], values[4 * t + 2]};
        const std::vector<float> samples =
            upsampler.sample({&color, 1}, SampleSelection::channels());
        const std::vector<float>& row = taken.rows[t / 37];
        differences += row[t % 37] != values[4 * t + 3];
        for (std::size_t p = 0; p < kTexelSamples; ++p) {
            differences += row[(p + 1) * 37 + t % 37] != samples[p];
        }
    }
    CHECK(differences == 0);
}

TEST_CASE("a file and the same image in an array are baked to the same bytes") {
    const auto folder = std::filesystem::temp_directory_path();
    const auto first = folder / ("specbake-bake-" + std::to_string(getpid()) + "-a.exr");
    const auto second = folder / ("specbake-bake-" + std::to_string(getpid()) + "-b.exr");
    TextureReader file(kImages + "rgba16.png");
    std::vector<std::byte> samples(file.info().bytesPerRow() *
                                   std::size_t(file.info().data.height));
    file.readRows(0, file.info().data.height, samples);
    MemoryImage image;
    image.width = file.info().data.width;
    image.height = file.info().data.height;
    image.channels = 4;
    image.alpha = 3;
    image.sampleType = TexelType::uint16;
    image.space = *findColorSpace("srgb");
    image.attributes = file.info().attributes;
    image.samples = samples;
    MemoryTexture texture(image);
    for (const bool chosen : {false, true}) {
        BakeOptions options;
        options.storage.mipmap = true;
        options.color.space = "srgb";  // the user's word, as that of the image in memory
        if (chosen) {                  // what goes through the texture more than once
            options.maxDeviation = 0.01;
            options.maxDE = 0.2;
        }
        bake(file, first, options);  // as a texture: a path's identity would stand in the result
        bake(texture, second, options);
        CHECK(contentsOf(first) == contentsOf(second));
        CHECK(contentsOf(first).size() > 1000);
    }
    std::filesystem::remove(first);
    std::filesystem::remove(second);
}

TEST_CASE("rows have no tiles, and options that cannot be are refused") {
    const auto values = texels(4);
    MemoryTexture texture(imageOf(values, 2, 2));
    const auto refused = [&texture](auto change) {
        BakeOptions options;
        change(options);
        CHECK_THROWS_AS(bake(texture, Rows().receiver(), options), ArgumentError);
    };
    refused([](BakeOptions& o) { o.storage.mipmap = true; });
    refused([](BakeOptions& o) { o.storage.tile = TileSize(); });
    refused([](BakeOptions& o) { o.bits = 11; });
    refused([](BakeOptions& o) { o.maxDE = std::nan(""); });
    refused([](BakeOptions& o) { o.maxDeviation = -1; });
    refused([](BakeOptions& o) { o.threads = -1; });
    refused([](BakeOptions& o) { o.model.grid = 1; });
    refused([](BakeOptions& o) { o.color.space = "none"; });
}
