#include "plain_png.h"

#include "support/png_file.h"
#include "support/same_image.h"
#include "support/temporary_file.h"

#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>

using namespace specbake;
using namespace specbake::testing;

namespace {

using Random = std::mt19937;

int below(Random& random, int end) {
    return std::uniform_int_distribution(0, end - 1)(random);
}

/// Rows of chance: any bytes behind any of the five filters are an image. Few different bytes, so
/// that the stream has matches and codes of several lengths.
std::string randomRows(Random& random, const PngFile& png) {
    std::string rows;
    const int kinds = 1 + below(random, 40);
    for (std::uint32_t y = 0; y < png.height; ++y) {
        rows += char(below(random, 5));
        for (std::size_t i = 0; i < png.rowBytes(); ++i) rows += char(below(random, kinds) * 37);
    }
    return rows;
}

PngFile randomPng(Random& random) {
    constexpr int colorTypes[] = {0, 2, 4, 6};
    PngFile png;
    png.width = std::uint32_t(1 + below(random, 40));
    png.height = std::uint32_t(1 + below(random, 40));
    png.bits = below(random, 2) == 0 ? 8 : 16;
    png.colorType = colorTypes[below(random, 4)];
    png.packed = zlibStream(randomRows(random, png), 1 + below(random, 12));
    for (int i = below(random, 6); i > 0; --i) {
        png.splits.push_back(std::size_t(below(random, int(png.packed.size()) + 1)));
    }
    std::sort(png.splits.begin(), png.splits.end());
    return png;
}

/// 3×2 RGB, as plain as can be.
PngFile smallPng() {
    PngFile png;
    png.width = 3;
    png.height = 2;
    png.packed = zlibStream(std::string(2 * (1 + png.rowBytes()), '\0'));
    return png;
}

std::string timeChunk(int month) {
    return pngChunk("tIME", bigEndian(2024, 2) + char(month) + "\x1d\x17\x3b\x3c");
}

std::string refusal(const PngFile& png) {
    const TemporaryFile file(png.contents());
    try {
        const auto image = openPlainPng(file.path());
        REQUIRE(image);
        allOf(*image);
    } catch (const FileError& error) {
        return std::string(error.what()).substr(file.path().size());
    }
    return "none";
}

/// cHRM of sRGB, whose last number may be another.
std::string primariesChunk(std::uint32_t blueY) {
    std::string data;
    for (const std::uint32_t number : {31270U, 32900U, 64000U, 33000U, 30000U, 60000U, 15000U}) {
        data += bigEndian(number, 4);
    }
    return pngChunk("cHRM", data + bigEndian(blueY, 4));
}

}  // namespace

TEST_CASE("the PNGs of testimages/ but the one with a palette are plain, and read the same") {
    for (const auto& entry :
         std::filesystem::directory_iterator(SPECBAKE_SOURCE_DIR "/testimages")) {
        const std::string path = entry.path().string();
        CAPTURE(path);
        const auto image = openPlainPng(path);
        const bool plain =
            entry.path().extension() == ".png" && entry.path().filename() != "palette.png";
        CHECK((image != nullptr) == plain);
        if (image) checkSameAsOpenImageIO(*image, path);
    }
}

TEST_CASE("any rows behind any filters in any chunks read the same") {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        const TemporaryFile file(randomPng(random).contents());
        const auto image = openPlainPng(file.path());
        REQUIRE(image);
        checkSameAsOpenImageIO(*image, file.path());
    }
}

TEST_CASE("a stream longer than any buffer reads the same") {
    Random random(2);
    PngFile png;
    png.width = 700;
    png.height = 300;
    png.colorType = 6;
    png.packed = zlibStream(randomRows(random, png));
    REQUIRE(png.packed.size() > 200'000);
    const TemporaryFile file(png.contents());
    const auto image = openPlainPng(file.path());
    REQUIRE(image);
    checkSameAsOpenImageIO(*image, file.path());
}

TEST_CASE("rows may be asked for in any order") {
    Random random(3);
    for (int i = 0; i < 20; ++i) {  // four in five first rows are filtered
        const PngFile png = randomPng(random);
        const TemporaryFile file(png.contents());
        const auto image = openPlainPng(file.path());
        REQUIRE(image);
        const std::vector<std::byte> all = allOf(*image);
        for (int n = 0; n < 20; ++n) {
            const int first = below(random, int(png.height));
            const int count = 1 + below(random, int(png.height) - first);
            const auto begin = all.begin() + std::ptrdiff_t(first) * std::ptrdiff_t(png.rowBytes());
            const auto end = begin + std::ptrdiff_t(count) * std::ptrdiff_t(png.rowBytes());
            CHECK(rowsOf(*image, first, count) == std::vector<std::byte>(begin, end));
        }
    }
}

TEST_CASE("what says nothing new beside the pixels, and a time, read the same") {
    const std::string chunks[] = {pngChunk("sRGB", std::string(1, '\0')),
                                  pngChunk("gAMA", bigEndian(45455, 4)), primariesChunk(6000),
                                  timeChunk(2), pngChunk("oFFs", std::string(9, '\0'))};
    PngFile png = smallPng();
    for (const std::string& chunk : chunks) {
        png.before += chunk;
        const TemporaryFile file(png.contents());
        const auto image = openPlainPng(file.path());
        REQUIRE(image);
        checkSameAsOpenImageIO(*image, file.path());
    }
}

TEST_CASE("anything else is left to OpenImageIO") {
    const std::string chunks[] = {pngChunk("gAMA", bigEndian(100000, 4)),
                                  primariesChunk(6001),
                                  pngChunk("pHYs", std::string(9, '\1')),
                                  pngChunk("oFFs", std::string(9, '\1')),
                                  pngChunk("tEXt", std::string("Author\0me", 9)),
                                  pngChunk("tRNS", std::string(6, '\0')),
                                  pngChunk("bKGD", std::string(6, '\0')),
                                  pngChunk("eXIf", "MM"),
                                  timeChunk(13),
                                  timeChunk(1) + timeChunk(1)};
    for (const std::string& chunk : chunks) {
        CAPTURE(chunk);
        PngFile png = smallPng();
        png.before = chunk;
        CHECK(openPlainPng(TemporaryFile(png.contents()).path()) == nullptr);
        png = smallPng();
        png.after = chunk;
        CHECK(openPlainPng(TemporaryFile(png.contents()).path()) == nullptr);
    }
    PngFile odd[] = {smallPng(), smallPng(), smallPng(), smallPng()};
    odd[0].bits = 4;
    odd[1].colorType = 3;
    odd[2].interlace = 1;
    odd[3].colorType = 5;
    for (const PngFile& png : odd) {
        CHECK(openPlainPng(TemporaryFile(png.contents()).path()) == nullptr);
    }
}

TEST_CASE("pixels that lack, do not unpack, have no such filter or are too many are refused") {
    PngFile png = smallPng();
    const std::string whole = png.packed;
    png.packed = zlibStream(std::string(2 * (1 + png.rowBytes()) - 1, '\0'));
    CHECK(refusal(png) == ": truncated: it lacks pixels");
    png.packed = whole.substr(0, 4);
    CHECK(refusal(png) == ": truncated: it lacks pixels");
    png.packed = "";
    CHECK(refusal(png) == ": truncated: it lacks pixels");
    png.packed = std::string(100, '\xff');
    CHECK(refusal(png) == ": damaged: its pixels cannot be unpacked");
    png.packed = zlibStream(std::string(2 * (1 + png.rowBytes()), '\5'));
    CHECK(refusal(png) == ": damaged: a row of no known filter");
    png.width = kLargestSide + 1;
    CHECK(refusal(png) == ": a side of more than 131072 pixels");
    png.width = 0;
    CHECK(refusal(png) == ": it has no pixels");
}

TEST_CASE("no damage to the pixels' stream does more than to be refused or to change pixels") {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        PngFile png = randomPng(random);
        for (int n = 1 + below(random, 3); n > 0; --n) {
            png.packed[std::size_t(below(random, int(png.packed.size())))] ^=
                char(1 << below(random, 8));
        }
        const std::string said = refusal(png);
        CAPTURE(said);
        CHECK((said == "none" || said == ": truncated: it lacks pixels" ||
               said == ": damaged: its pixels cannot be unpacked" ||
               said == ": damaged: a row of no known filter"));
    }
}
