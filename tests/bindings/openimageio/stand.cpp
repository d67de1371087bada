#include "stand.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <fstream>
#include <random>

namespace specbake::testing {

namespace fs = std::filesystem;

const std::string kImages = SPECBAKE_SOURCE_DIR "/testimages/";

Stand::Stand()
    : folder(fs::temp_directory_path() / ("specbake_plugin." + std::to_string(getpid()))) {
    fs::create_directories(folder);
    OIIO::attribute("plugin_searchpath", SPECBAKE_PLUGIN_FOLDER);
}

Stand::~Stand() {
    fs::remove_all(folder);
}

std::string Stand::recipe(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return path(name);
}

std::string Stand::baked(const std::string& texture, BakeOptions options) const {
    options.storage.compression = Compression::none;
    if (!options.storage.tile) options.storage.tile = TileSize{};
    bake(texture, path("baked.exr"), options);
    return path("baked.exr");
}

std::unique_ptr<OIIO::ImageInput> opened(const std::string& path) {
    auto input = OIIO::ImageInput::open(path);
    CAPTURE(path);
    CAPTURE(OIIO::geterror());
    REQUIRE(input);
    return input;
}

std::vector<std::byte> samplesOf(OIIO::ImageInput& input, int level, int first, int end) {
    const OIIO::ImageSpec spec = input.spec(0, level);
    const std::size_t pixels = std::size_t(spec.width) * std::size_t(spec.height);
    std::vector<std::byte> samples(pixels * spec.format.size() * std::size_t(end - first));
    const bool read = input.read_image(0, level, first, end, spec.format, samples.data());
    CAPTURE(input.geterror());
    REQUIRE(read);
    return samples;
}

namespace {

bool sameDimensions(const OIIO::ImageSpec& a, const OIIO::ImageSpec& b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height &&
           a.full_x == b.full_x && a.full_y == b.full_y && a.full_width == b.full_width &&
           a.full_height == b.full_height && a.tile_width == b.tile_width &&
           a.tile_height == b.tile_height && a.tile_depth == b.tile_depth && a.format == b.format &&
           a.channelnames == b.channelnames && a.alpha_channel == b.alpha_channel;
}

/// Of how the file is stored, which a computed image is not.
bool isOfStorage(const std::string& name) {
    return name.starts_with("openexr:") || name.starts_with("screenWindow") ||
           name == "compression" || name == "specbake:identity";
}

void checkSameMetadata(const OIIO::ImageSpec& computed, const OIIO::ImageSpec& baked) {
    for (const auto& attribute : baked.extra_attribs) {
        const std::string name = attribute.name().string();
        if (isOfStorage(name)) continue;
        CAPTURE(name);
        const auto* other = computed.find_attribute(name);
        REQUIRE(other != nullptr);
        CHECK(other->type() == attribute.type());
        CHECK(other->get_string() == attribute.get_string());
    }
    for (const auto& attribute : computed.extra_attribs) {
        CAPTURE(attribute.name().string());
        CHECK(baked.find_attribute(attribute.name()) != nullptr);
    }
}

}  // namespace

void checkSameImage(const std::string& computed, const std::string& baked) {
    const auto ours = opened(computed);
    const auto theirs = opened(baked);
    std::mt19937 random(1);
    checkSameMetadata(ours->spec(0, 0), theirs->spec(0, 0));
    int level = 0;
    for (; theirs->seek_subimage(0, level); ++level) {
        CAPTURE(level);
        REQUIRE(ours->seek_subimage(0, level));
        const OIIO::ImageSpec spec = ours->spec(0, level);
        CHECK(sameDimensions(spec, theirs->spec(0, level)));
        CHECK(samplesOf(*ours, level, 0, spec.nchannels) ==
              samplesOf(*theirs, level, 0, spec.nchannels));
        for (int i = 0; i < 3; ++i) {
            const int first = int(random() % unsigned(spec.nchannels));
            const int end = first + 1 + int(random() % unsigned(spec.nchannels - first));
            CAPTURE(first);
            CAPTURE(end);
            CHECK(samplesOf(*ours, level, first, end) == samplesOf(*theirs, level, first, end));
        }
    }
    CHECK(!ours->seek_subimage(0, level));
    CHECK(!ours->seek_subimage(1, 0));
    std::byte nothing{};
    const int x = ours->spec(0, 0).x;
    const int y = ours->spec(0, 0).y;
    CHECK(!ours->read_native_tiles(0, 0, x + 1, x + 2, y, y + 1, 0, 1, 0, 1, &nothing));
    CHECK(!ours->read_native_tiles(0, 0, x - 64, x, y, y + 1, 0, 1, 0, 1, &nothing));
    CHECK(!ours->read_native_tiles(0, 0, x, x + 1, y, y + 1, 0, 1, 3, 3, &nothing));
}

}  // namespace specbake::testing
