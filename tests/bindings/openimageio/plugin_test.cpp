#include "stand.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

using namespace specbake;
using namespace specbake::testing;

namespace fs = std::filesystem;

TEST_CASE("every test image opens as what a bake would write, to the last bit") {
    const Stand stand;
    BakeOptions options;
    options.storage.mipmap = true;
    for (const auto& file : fs::directory_iterator(kImages)) {
        const std::string name = file.path().filename().string();
        const std::string extension = file.path().extension().string();
        if (extension == ".txt" || extension == ".md" || extension == ".cpp" || extension == ".h") {
            continue;
        }
        CAPTURE(name);
        checkSameImage(file.path().string() + ".spectral",
                       stand.baked(file.path().string(), options));
    }
}

TEST_CASE("a large texture of odd sides, by many threads at once") {
    const Stand stand;
    const std::string source = stand.path("noise.tif");
    OIIO::ImageSpec spec(421, 333, 4, OIIO::TypeUInt8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    std::vector<std::uint8_t> samples(std::size_t(421) * 333 * 4);
    std::mt19937 random(5);
    std::generate(samples.begin(), samples.end(), [&] { return std::uint8_t(random()); });
    auto output = OIIO::ImageOutput::create(source);
    REQUIRE(output->open(source, spec));
    REQUIRE(output->write_image(OIIO::TypeUInt8, samples.data()));
    output->close();

    BakeOptions options;
    options.storage.mipmap = true;
    const std::string baked = stand.baked(source, options);
    checkSameImage(source + ".spectral", baked);
    const auto ours = opened(source + ".spectral");
    const auto theirs = opened(baked);
    std::vector<std::vector<std::byte>> wanted;
    for (int level = 0; level < 9; ++level) wanted.push_back(samplesOf(*theirs, level, 2, 30));
    std::vector<int> wrong(8, 0);
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < wrong.size(); ++t) {
            threads.emplace_back([&, t] {
                for (int i = 0; i < 9; ++i) {
                    const int level = int(t + std::size_t(i) * 5) % 9;  // in another order each
                    const OIIO::ImageSpec s = ours->spec(0, level);
                    std::vector<std::byte> got(wanted[std::size_t(level)].size());
                    const bool read =
                        ours->read_tiles(0, level, s.x, s.x + s.width, s.y, s.y + s.height, 0, 1, 2,
                                         30, s.format, got.data());
                    if (!read || got != wanted[std::size_t(level)]) ++wrong[t];
                }
            });
        }
    }
    CHECK(std::count(wrong.begin(), wrong.end(), 0) == 8);
}

TEST_CASE("ImageBuf, ImageCache and TextureSystem see the baked file's values") {
    const Stand stand;
    BakeOptions options;
    options.storage.mipmap = true;
    const std::string computed = kImages + "demo.png.spectral";
    const std::string baked = stand.baked(kImages + "demo.png", options);

    OIIO::ImageBuf ours(computed);
    OIIO::ImageBuf theirs(baked);
    REQUIRE(ours.read(0, 1, true, OIIO::TypeFloat));
    REQUIRE(theirs.read(0, 1, true, OIIO::TypeFloat));
    const auto bytes = ours.spec().image_bytes();
    REQUIRE(bytes == theirs.spec().image_bytes());
    CHECK(std::memcmp(ours.localpixels(), theirs.localpixels(), bytes) == 0);

    const auto free = [](OIIO::ImageCache* cache) { OIIO::ImageCache::destroy(cache); };
    const std::unique_ptr<OIIO::ImageCache, decltype(free)> cache(OIIO::ImageCache::create(false),
                                                                  free);
    for (int level = 0; level < 4; ++level) {
        OIIO::ImageSpec spec;
        REQUIRE(cache->get_imagespec(OIIO::ustring(baked), spec, 0, level));
        const std::size_t count = std::size_t(spec.width) * std::size_t(spec.height) * 4;
        std::vector<float> a(count);
        std::vector<float> b(count);
        for (const auto& [file, to] : {std::pair(computed, &a), std::pair(baked, &b)}) {
            REQUIRE(cache->get_pixels(OIIO::ustring(file), 0, level, 0, spec.width, 0, spec.height,
                                      0, 1, 20, 24, OIIO::TypeFloat, to->data()));
        }
        CHECK(a == b);
    }

    // The shared one, which is never deleted: OpenImageIO 2.4.7 deletes another by a wrong size.
    OIIO::TextureSystem* const textures = OIIO::TextureSystem::create(true);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> anywhere(0, 1);
    for (int i = 0; i < 500; ++i) {
        OIIO::TextureOpt first;
        OIIO::TextureOpt second;
        for (OIIO::TextureOpt* opt : {&first, &second}) {
            opt->firstchannel = 40;
            opt->mipmode = OIIO::TextureOpt::MipModeTrilinear;
        }
        const float s = anywhere(random);
        const float t = anywhere(random);
        const float width = anywhere(random) * 0.2F;
        float a[4] = {};
        float b[4] = {};
        REQUIRE(textures->texture(OIIO::ustring(computed), first, s, t, width, 0, 0, width, 4, a));
        REQUIRE(textures->texture(OIIO::ustring(baked), second, s, t, width, 0, 0, width, 4, b));
        CHECK(std::equal(a, a + 4, b));
    }
}

TEST_CASE("what cannot be opened or read is told in one line") {
    const Stand stand;
    std::ofstream(stand.path("wide.png"), std::ios::binary) << "no picture";
    const std::string source = "source = " + kImages + "rgb8.png\n";
    const std::string cases[][2] = {
        {stand.path("absent.png.spectral"), "is no file"},
        {stand.path("wide.png.spectral"), "wide.png"},
        {stand.recipe("a.spectral", source + "method = guess\n"), "guess"},
        {stand.recipe("b.spectral", source + "\nfoo = 1\n"), "line 3: no option 'foo'"},
        {stand.recipe("c.spectral", source + "tile = 99999 64\n"), "tile"},
    };
    for (const auto& [path, reason] : cases) {
        CAPTURE(path);
        CHECK(!OIIO::ImageInput::open(path));
        const std::string told = OIIO::geterror();
        CHECK(told.find(reason) != std::string::npos);
        CHECK(told.find('\n') == std::string::npos);
    }
    // A texel without a spectrum: the tile that holds it cannot be read, others can.
    OIIO::ImageBuf texture(OIIO::ImageSpec(100, 20, 3, OIIO::TypeFloat));
    const float no[] = {NAN, 0, 0};
    texture.setpixel(80, 3, no);
    REQUIRE(texture.write(stand.path("nan.exr")));
    const auto input = opened(stand.path("nan.exr.spectral"));
    std::vector<float> tile(std::size_t(64) * 64 * 84);
    CHECK(input->read_tile(0, 0, 0, OIIO::TypeFloat, tile.data()));
    CHECK(!input->read_tile(64, 0, 0, OIIO::TypeFloat, tile.data()));
    CHECK(input->geterror().find("pixel (80, 3) is not a finite number") != std::string::npos);
}
