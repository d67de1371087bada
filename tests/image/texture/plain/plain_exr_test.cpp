#include "texture/plain/plain_exr.h"

#include "support/below.h"
#include "support/contents.h"
#include "support/same_image.h"
#include "support/temporary_file.h"

#include <specbake/core/error.h>
#include <specbake/image/spectral_layout.h>

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <array>
#include <cstring>
#include <random>
#include <set>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

using Random = std::mt19937;
using Names = std::vector<std::string>;

const std::array<Names, 8> kChannels = {Names{"Y"},           Names{"Y", "A"},
                                        Names{"R", "G", "B"}, Names{"R", "G", "B", "A"},
                                        Names{"X", "Y", "Z"}, Names{"X", "Y", "Z", "A"},
                                        channelNames(false),  channelNames(true)};

OIIO::ImageSpec specOf(const Names& names, int width, int height, OIIO::TypeDesc type) {
    OIIO::ImageSpec spec(width, height, int(names.size()), type);
    spec.channelnames = names;
    const auto alpha = std::find(names.begin(), names.end(), "A");
    spec.alpha_channel = alpha == names.end() ? -1 : int(alpha - names.begin());
    spec.attribute("compression", "zip");
    return spec;
}

/// Samples of chance, few of them different, so that chunks shrink.
void write(const std::string& path, const OIIO::ImageSpec& spec, Random& random) {
    std::vector<float> samples(spec.image_pixels() * std::size_t(spec.nchannels));
    for (float& sample : samples) sample = float(below(random, 9)) / 7;
    const auto out = OIIO::ImageOutput::create(path);
    REQUIRE(out);
    REQUIRE(out->open(path, spec));
    REQUIRE(out->write_image(OIIO::TypeFloat, samples.data()));
    REQUIRE(out->close());
}

OIIO::ImageSpec randomSpec(Random& random) {
    constexpr const char* compressions[] = {"none", "zip", "zips", "piz"};
    const Names& names = kChannels[std::size_t(below(random, int(kChannels.size())))];
    OIIO::ImageSpec spec = specOf(names, 1 + below(random, 40), 1 + below(random, 70),
                                  below(random, 2) == 0 ? OIIO::TypeHalf : OIIO::TypeFloat);
    spec.x = below(random, 20) - 10;
    spec.y = below(random, 20) - 10;
    spec.full_x = below(random, 20) - 10;
    spec.full_width = 1 + below(random, 90);
    spec.attribute("compression", compressions[below(random, 4)]);
    if (below(random, 2) == 0) spec.attribute("PixelAspectRatio", 0.25F + float(below(random, 8)));
    if (below(random, 2) == 0) spec.attribute("specbake:illuminant", "D65");
    if (below(random, 2) == 0) spec.attribute("specbake:grid", 17);
    if (below(random, 2) == 0) spec.attribute("DateTime", "2024:02:29 23:59:60");
    return spec;
}

void checkFacts(const ImageFile& image, const std::string& path) {
    const auto in = OIIO::ImageInput::open(path);
    REQUIRE(in);
    const std::optional<StorageFacts> facts = image.facts();
    CHECK(facts.has_value() == (image.description().pixelAspectRatio == 1));
    if (!facts) return;
    CHECK(facts->channels == in->spec().nchannels);
    CHECK(facts->sampleType == in->spec().format.c_str());
    CHECK(facts->compression == in->spec().get_string_attribute("compression"));
    CHECK(facts->tileWidth == in->spec().tile_width);
    CHECK(facts->levels == 1);
    for (const auto& [name, value] : facts->attributes) {
        CAPTURE(name);
        CHECK(value == in->spec()[name].get());
    }
    for (const char* name : {"specbake:illuminant", "specbake:grid", "DateTime"}) {
        const auto found = std::find_if(facts->attributes.begin(), facts->attributes.end(),
                                        [&](const auto& a) { return a.first == name; });
        CHECK((found != facts->attributes.end()) == (in->spec().find_attribute(name) != nullptr));
    }
}

}  // namespace

TEST_CASE("the EXRs of testimages/ that are plain read the same") {
    const std::set<std::string> others = {"mipmap.exr", "tiled_offset.exr", "rgb_float.exr"};
    for (const auto& entry :
         std::filesystem::directory_iterator(SPECBAKE_SOURCE_DIR "/testimages")) {
        const std::string path = entry.path().string();
        CAPTURE(path);
        const auto image = openPlainExr(path);
        const bool plain = entry.path().extension() == ".exr" &&
                           !others.contains(entry.path().filename().string());
        CHECK((image != nullptr) == plain);
        if (image) checkSameAsOpenImageIO(*image, path);
    }
}

TEST_CASE("any channels, windows, compression and type read the same") {
    Random random(1);
    for (int i = 0; i < 150; ++i) {
        const TemporaryFile file("", ".exr");
        const OIIO::ImageSpec spec = randomSpec(random);
        CAPTURE(i);
        write(file.path(), spec, random);
        const auto image = openPlainExr(file.path());
        REQUIRE(image);
        checkSameAsOpenImageIO(*image, file.path());
        checkFacts(*image, file.path());
    }
}

TEST_CASE("rows may be asked for in any order, and halves as floats") {
    Random random(2);
    const TemporaryFile file("", ".exr");
    write(file.path(), specOf({"Y"}, 5, 40, OIIO::TypeHalf), random);
    const auto image = openPlainExr(file.path());
    REQUIRE(image);
    std::vector<float> all(5 * 40);
    const auto in = OIIO::ImageInput::open(file.path());
    REQUIRE(in->read_image(0, 0, 0, 1, OIIO::TypeFloat, all.data()));
    for (int i = 0; i < 100; ++i) {
        const int first = below(random, 40);
        const int count = 1 + below(random, 40 - first);
        std::vector<float> rows(std::size_t(5 * count));
        image->readRows(first, count, TexelType::float32, std::as_writable_bytes(std::span(rows)));
        CHECK(rows ==
              std::vector<float>(all.begin() + 5 * first, all.begin() + 5 * (first + count)));
        CHECK(rowsOf(*image, first, 1).size() == 10);
    }
}

TEST_CASE("anything else is left to OpenImageIO") {
    Random random(3);
    const OIIO::ImageSpec plain = specOf({"R", "G", "B"}, 4, 4, OIIO::TypeHalf);
    std::vector<OIIO::ImageSpec> others(8, plain);
    others[0].attribute("compression", "b44");
    others[1].attribute("openexr:lineOrder", "decreasingY");
    others[2].attribute("Copyright", "me");
    others[3].attribute("weight", 2);
    others[4].channelnames = {"R", "G", "N"};
    others[5].channelnames = {"left.R", "left.G", "left.B"};
    others[6].tile_width = others[6].tile_height = 16;
    others[7].channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeFloat};
    const TemporaryFile file("", ".exr");
    for (const OIIO::ImageSpec& spec : others) {
        write(file.path(), spec, random);
        CHECK(openPlainExr(file.path()) == nullptr);
    }
    write(file.path(), plain, random);
    CHECK(openPlainExr(file.path()) != nullptr);
    OIIO::ImageSpec large = specOf({"Y"}, 2049, 2048, OIIO::TypeHalf);
    write(file.path(), large, random);
    CHECK(openPlainExr(file.path()) != nullptr);
    large.attribute("compression", "piz");
    write(file.path(), large, random);
    CHECK(openPlainExr(file.path()) == nullptr);
}

TEST_CASE("a file cut anywhere is refused here or left to OpenImageIO") {
    Random random(4);
    const TemporaryFile whole("", ".exr");
    write(whole.path(), randomSpec(random), random);
    const std::string contents = contentsOf(whole.path());
    for (int i = 0; i < 300; ++i) {
        const auto size = std::size_t(below(random, int(contents.size())));
        const TemporaryFile cut(contents.substr(0, size), ".cut.exr");
        const auto image = openPlainExr(cut.path());
        if (image) CHECK_THROWS_AS(allOf(*image), FileError);
    }
}

TEST_CASE("no damage does more than to be refused or to change pixels") {
    Random random(5);
    for (int i = 0; i < 40; ++i) {
        const TemporaryFile whole("", ".exr");
        write(whole.path(), randomSpec(random), random);
        const std::string contents = contentsOf(whole.path());
        for (int n = 0; n < 50; ++n) {
            std::string damaged = contents;
            for (int k = 1 + below(random, 3); k > 0; --k) {
                damaged[std::size_t(below(random, int(damaged.size())))] ^=
                    char(1 << below(random, 8));
            }
            const TemporaryFile file(damaged, ".damaged.exr");
            try {
                if (const auto image = openPlainExr(file.path())) allOf(*image);
            } catch (const FileError& error) {
                CHECK(std::string(error.what()).find('\n') == std::string::npos);
            }
        }
    }
}
