#include <specbake/bake/bake.h>
#include <specbake/image/texture_reader.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

using namespace specbake;

namespace fs = std::filesystem;

namespace {

const std::string kImages = SPECBAKE_SOURCE_DIR "/testimages/";

/// A folder of this test, and a reader of OpenImageIO that looks for plugins where ours is.
struct Stand {
    fs::path folder = fs::temp_directory_path() / ("specbake_plugin." + std::to_string(getpid()));
    Stand() {
        fs::create_directories(folder);
        OIIO::attribute("plugin_searchpath", SPECBAKE_PLUGIN_FOLDER);
    }
    ~Stand() { fs::remove_all(folder); }

    std::string path(const std::string& name) const { return (folder / name).string(); }

    /// NAME.spectral with that text.
    std::string recipe(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
        return path(name);
    }

    /// What a bake with these options writes.
    std::string baked(const std::string& texture, BakeOptions options) const {
        options.storage.compression = Compression::none;
        if (!options.storage.tile) options.storage.tile = TileSize{};
        bake(texture, path("baked.exr"), options);
        return path("baked.exr");
    }
};

std::unique_ptr<OIIO::ImageInput> opened(const std::string& path) {
    auto input = OIIO::ImageInput::open(path);
    CAPTURE(path);
    CAPTURE(OIIO::geterror());
    REQUIRE(input);
    return input;
}

/// All samples of a level, as they are stored.
std::vector<std::byte> samplesOf(OIIO::ImageInput& input, int level, int first, int end) {
    const OIIO::ImageSpec spec = input.spec(0, level);
    const std::size_t pixels = std::size_t(spec.width) * std::size_t(spec.height);
    std::vector<std::byte> samples(pixels * spec.format.size() * std::size_t(end - first));
    const bool read = input.read_image(0, level, first, end, spec.format, samples.data());
    CAPTURE(input.geterror());
    REQUIRE(read);
    return samples;
}

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

/// Every level: dimensions, metadata, samples of all channels, and of some runs of them.
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

}  // namespace

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
