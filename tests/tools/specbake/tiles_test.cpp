#include "process.h"
#include "read_back.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/verify.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenImageIO/imagebufalgo.h>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace specbake;
using namespace specbake::testing;

namespace {

/// A spectral file in a folder of its own.
struct Baked {
    Scratch scratch;
    std::string path;

    Baked(const std::string& image, const StorageOptions& storage, int bits = 10)
        : path(scratch.path("o.exr")) {
        BakeOptions options;
        options.storage = storage;
        options.bits = bits;
        bake(testImage(image), path, options);
    }
};

/// All samples of the first level by OpenEXR's C++ classes, channel by channel.
std::vector<float> readByOpenEXR(const std::string& path) {
    Imf::InputFile input(path.c_str());
    const Imath::Box2i box = input.header().dataWindow();
    const std::ptrdiff_t width = box.max.x - box.min.x + 1;
    const std::ptrdiff_t plane = width * (box.max.y - box.min.y + 1);
    std::vector<std::string> names;
    const Imf::ChannelList& channels = input.header().channels();
    for (auto c = channels.begin(); c != channels.end(); ++c) names.emplace_back(c.name());
    std::vector<float> samples(std::size_t(plane) * names.size());
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < names.size(); ++c) {
        float* base = samples.data() + std::ptrdiff_t(c) * plane - box.min.y * width - box.min.x;
        frame.insert(names[c].c_str(),
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(base), sizeof(float),
                                sizeof(float) * std::size_t(width)));
    }
    input.setFrameBuffer(frame);
    input.readPixels(box.min.y, box.max.y);
    return samples;
}

/// The storage of some image: each combination comes up for some of them.
StorageOptions storageOf(std::size_t i, bool mipmap) {
    constexpr Compression all[] = {Compression::zip, Compression::piz, Compression::zips,
                                   Compression::none};
    const auto type = i % 2 == 0 ? SampleType::half : SampleType::float32;
    return {type, all[i / 2 % 4], 3, TileSize{16, i % 3 == 0 ? 5 : 16}, mipmap};
}

int length(int from) {
    return std::max(1, from / 2);
}

/// What texel i of a side takes of texel x of the side above: by the overlap of their stretches.
double share(int i, int x, int side) {
    const double covered = double(side) / length(side);
    const double overlap = std::min(x + 1.0, (i + 1) * covered) - std::max(double(x), i * covered);
    return std::max(0.0, overlap) / covered;
}

/// A level in double precision: the bands, then alpha (1 if the file has none).
struct Level {
    int width, height;
    std::vector<std::array<double, 82>> texels;
    std::array<double, 82>& at(int x, int y) {
        return texels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

Level levelOf(const ReadBack& file) {
    Level level{file.spec.width, file.spec.height, {}};
    std::vector<int> channels;
    for (int nm = 380; nm <= 780; nm += 5) channels.push_back(file.spec.channelindex(bandName(nm)));
    channels.push_back(file.spec.channelindex("A"));
    for (std::size_t t = 0; t < file.spec.image_pixels(); ++t) {
        auto& texel = level.texels.emplace_back();
        for (std::size_t c = 0; c < texel.size(); ++c) {
            const auto at = t * std::size_t(file.spec.nchannels) + std::size_t(channels[c]);
            texel[c] = channels[c] < 0 ? 1.0 : double(file.samples[at]);
        }
    }
    return level;
}

/// The definition of docs/file-format.md, texel by texel.
std::array<double, 82> average(Level& above, int i, int j) {
    std::array<double, 82> seen{};
    std::array<double, 82> all{};
    double sum = 0;
    for (int y = 2 * j; y < std::min(above.height, 2 * j + 3); ++y) {
        for (int x = 2 * i; x < std::min(above.width, 2 * i + 3); ++x) {
            const auto& texel = above.at(x, y);
            const double area = share(i, x, above.width) * share(j, y, above.height);
            sum += area * texel[81];
            for (std::size_t c = 0; c < 82; ++c) {
                all[c] += area * texel[c];
                seen[c] += area * texel[81] * texel[c];
            }
        }
    }
    for (std::size_t c = 0; c < 81 && sum > 0; ++c) all[c] = seen[c] / sum;
    return all;
}

Level below(Level& above) {
    Level level{length(above.width), length(above.height), {}};
    for (int j = 0; j < level.height; ++j) {
        for (int i = 0; i < level.width; ++i) level.texels.push_back(average(above, i, j));
    }
    return level;
}

double difference(const Level& a, const Level& b) {
    double largest = 0;
    for (std::size_t t = 0; t < a.texels.size(); ++t) {
        for (std::size_t c = 0; c < 82; ++c) {
            largest = std::max(largest, std::abs(a.texels[t][c] - b.texels[t][c]));
        }
    }
    return largest;
}

/// Values up to 1 are off by at most 2⁻¹² as halves (2⁻²⁵ as floats), here and, averaged, in the
/// level 0 of the file. So is alpha, relatively by 2⁻¹¹ (2⁻²⁴): weights off by as much move an
/// average by at most that times the mean distance from it, which is at most 1/2. Between levels
/// there are floats, which add 2⁻²⁴ each: 2⁻²⁵ of the values and as much by the weights.
double tolerance(SampleType type, int level) {
    const double rounding = type == SampleType::half ? 0x1p-12 : 0x1p-25;
    return 3 * rounding + level * 0x1p-24;
}

void checkLevels(const std::string& path, SampleType type) {
    Level expected = levelOf(ReadBack(path));
    int level = 0;
    while (expected.width > 1 || expected.height > 1) {
        expected = below(expected);
        const Level found = levelOf(ReadBack(path, ++level));
        REQUIRE(found.width == expected.width);
        REQUIRE(found.height == expected.height);
        CHECK(difference(found, expected) <= tolerance(type, level));
    }
    CHECK_THROWS(ReadBack(path, level + 1));
}

}  // namespace

TEST_SUITE_BEGIN("tiles");

TEST_CASE("tiles and mipmaps hold the samples of the scan lines, bit for bit") {
    const std::vector<std::string> images = testImages();
    for (std::size_t i = 0; i < images.size(); ++i) {
        CAPTURE(images[i]);
        StorageOptions plain = storageOf(i, false);
        plain.tile = std::nullopt;
        const Baked lines(images[i], plain);
        const ReadBack expected(lines.path);
        const std::vector<float> byOpenEXR = readByOpenEXR(lines.path);
        const auto difference = verify(lines.path, testImage(images[i]), {}).maxDE2000;
        for (const bool mipmap : {false, true}) {
            CAPTURE(mipmap);
            const Baked tiles(images[i], storageOf(i, mipmap));
            CHECK(tiles.scratch.names() == std::vector<std::string>{"o.exr"});
            const ReadBack found(tiles.path);
            CHECK(found.spec.tile_width == 16);
            CHECK(found.spec.channelnames == expected.spec.channelnames);
            CHECK(std::array{found.spec.x, found.spec.y, found.spec.full_x, found.spec.full_y} ==
                  std::array{expected.spec.x, expected.spec.y, expected.spec.full_x,
                             expected.spec.full_y});
            CHECK(found.samples == expected.samples);
            CHECK(readByOpenEXR(tiles.path) == byOpenEXR);
            CHECK(verify(tiles.path, testImage(images[i]), {}).maxDE2000 == difference);
        }
    }
}

TEST_CASE("each mip level is the average of the spectra that it covers") {
    const std::vector<std::string> images = testImages();
    for (std::size_t i = 0; i < images.size(); ++i) {
        CAPTURE(images[i]);
        const StorageOptions storage = storageOf(i, true);
        checkLevels(Baked(images[i], storage).path, storage.sampleType);
    }
}

TEST_CASE("levels average what alpha lets through, in tiles of any height") {
    for (const int height : {1, 7, 64}) {
        const StorageOptions storage{SampleType::float32, Compression::zip, 3, TileSize{9, height},
                                     true};
        for (const char* image : {"rgba8.png", "17x33.png", "tiled_offset.exr"}) {
            checkLevels(Baked(image, storage).path, SampleType::float32);
        }
    }
}

TEST_CASE("--bits holds for every level") {
    const StorageOptions storage{SampleType::half, Compression::zip, 3, std::nullopt, true};
    const Baked baked("17x33.png", storage, 5);
    for (int level = 0; level < 6; ++level) {
        for (const float sample : ReadBack(baked.path, level).samples) {
            CHECK((Imath::half(sample).bits() & 0x1F) == 0);
        }
    }
}

TEST_CASE("the program bakes tiles and mipmaps, and says of a file that it has them") {
    const Scratch scratch;
    const std::string path = scratch.path("o.exr");
    const auto facts = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"bake", "-q", testImage("17x33.png"), "-o", path});
        REQUIRE(runTool(options).exitCode == 0);
        return nlohmann::json::parse(runTool({"inspect", path, "--json"}).out);
    };
    const auto tiles = facts({"--tile", "16", "8"});
    CHECK(tiles.at("tile") == nlohmann::json({16, 8}));
    CHECK(tiles.at("mip_levels") == 1);
    const auto levels = facts({"--mipmap", "--max-de", "0.1", "--stats", scratch.path("s.json")});
    CHECK(levels.at("tile") == nlohmann::json({64, 64}));
    CHECK(levels.at("mip_levels") == 6);
    const std::string text = runTool({"inspect", path}).out;
    CHECK(text.find("tiles 64 x 64, 6 mip levels\n") != std::string::npos);
    CHECK(runTool({"verify", path, testImage("17x33.png")}).exitCode == 0);
}

TEST_CASE("mipmaps that others make of a spectral file are read") {
    const Baked baked("rgb8.png", {});
    const std::string theirs = baked.scratch.path("tx.exr");
    OIIO::ImageSpec wishes;
    wishes.tile_width = wishes.tile_height = 32;
    REQUIRE(OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, baked.path, theirs,
                                             wishes));
    REQUIRE(ReadBack(theirs, 1).spec.width == 12);
    CHECK(verify(theirs, testImage("rgb8.png"), {}).maxDE2000 <= 0.03);  // every_image_test.cpp
    CHECK(runTool({"inspect", theirs, "--at", "3", "4"}).out ==
          runTool({"inspect", baked.path, "--at", "3", "4"}).out);
    const std::string picture = baked.scratch.path("p.png");
    REQUIRE(runTool({"relight", theirs, "-o", picture, "--illuminant", "D65"}).exitCode == 0);
    CHECK(ReadBack(picture).samples == ReadBack(testImage("rgb8.png")).samples);
}

TEST_SUITE_END();
