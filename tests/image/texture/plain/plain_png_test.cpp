#include "texture/plain/plain_png.h"

#include "support/below.h"
#include "support/png_file.h"
#include "support/same_image.h"
#include "support/temporary_file.h"

#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

using Random = std::mt19937;

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

void checkReadsTheSame(const PngFile& png) {
    const TemporaryFile file(png.contents());
    const auto image = openPlainPng(file.path());
    REQUIRE(image);
    checkSameAsOpenImageIO(*image, file.path());
}

bool isLeftToOpenImageIO(const PngFile& png) {
    return openPlainPng(TemporaryFile(png.contents()).path()) == nullptr;
}

std::string primariesChunk() {
    std::string data;
    for (const std::uint32_t number :
         {31270U, 32900U, 68000U, 32000U, 26500U, 69000U, 15000U, 6000U}) {
        data += bigEndian(number, 4);
    }
    return pngChunk("cHRM", data);
}

}  // namespace

TEST_CASE("the PNGs of testimages/ read the same") {
    for (const auto& entry :
         std::filesystem::directory_iterator(SPECBAKE_SOURCE_DIR "/testimages")) {
        const std::string path = entry.path().string();
        CAPTURE(path);
        const auto image = openPlainPng(path);
        CHECK((image != nullptr) == (entry.path().extension() == ".png"));
        if (image) checkSameAsOpenImageIO(*image, path);
    }
}

TEST_CASE("an offset beyond what an EXR can say is told and not used") {
    for (const std::uint32_t offset : {0x7fffffffU, 0x80000001U, 0x40000000U}) {
        PngFile png;
        png.packed = zlibStream(std::string(4, '\0'));
        png.before = pngChunk("oFFs", bigEndian(offset, 4) + bigEndian(offset, 4) + '\0');
        const TemporaryFile file(png.contents());
        const auto image = openPlainPng(file.path());
        REQUIRE(image);
        CHECK(image->description().data == Window{0, 0, 1, 1});
        CHECK(image->description().notes.size() == 1);
    }
}

TEST_CASE("any rows behind any filters in any chunks read the same") {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        checkReadsTheSame(randomPng(random));
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
    checkReadsTheSame(png);
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

TEST_CASE("what stands beside the pixels reads the same") {
    const auto resolution = [](std::uint32_t x, std::uint32_t y, char unit) {
        return pngChunk("pHYs", bigEndian(x, 4) + bigEndian(y, 4) + unit);
    };
    const std::string xmp("XML:com.adobe.xmp\0\0\0\0\0<x/>", 26);
    struct Chunk {
        std::string bytes;
        bool plain;
    };
    const Chunk chunks[] = {
        {pngChunk("sRGB", std::string(1, '\0')), true},
        {pngChunk("gAMA", bigEndian(45455, 4)), true},
        {pngChunk("gAMA", bigEndian(100000, 4)), true},
        {primariesChunk(), true},
        {timeChunk(2), true},
        {timeChunk(13), true},
        {timeChunk(1) + timeChunk(1), true},
        {pngChunk("oFFs", std::string(9, '\0')), true},
        {pngChunk("oFFs", bigEndian(7, 4) + bigEndian(3, 4) + '\0'), true},
        {resolution(2835, 2835, 1), true},
        {resolution(1000, 3000, 1), true},
        {resolution(3, 2, 0), true},
        {resolution(0, 2, 0), true},
        {pngChunk("tEXt", std::string("Author\0me", 9)), true},
        {pngChunk("tEXt", std::string("title\0it", 8)), true},
        {pngChunk("tEXt", std::string("Description\0that", 16)), true},
        {pngChunk("tEXt", std::string("Software\0this", 13)), true},
        {pngChunk("tEXt", std::string("Place\0here", 10)), true},
        {pngChunk("zTXt", std::string("Sky\0\0", 5) + zlibStream("blue")), true},
        {pngChunk("tRNS", std::string(6, '\0')), true},
        {pngChunk("bKGD", std::string(6, '\0')), true},
        {pngChunk("abCd", "?"), true},
        {pngChunk("iTXt", xmp), false},
        {pngChunk("tEXt", std::string("Raw profile type exif\0x", 23)), false},
        {pngChunk("eXIf", std::string("MM\0*\0\0\0\10\0\0", 10)), true}};
    for (const Chunk& chunk : chunks) {
        CAPTURE(chunk.bytes);
        PngFile png = smallPng();
        png.before = chunk.bytes;
        if (chunk.plain) {
            checkReadsTheSame(png);
        } else {
            CHECK(isLeftToOpenImageIO(png));
        }
        png = smallPng();
        png.after = chunk.bytes;
        checkReadsTheSame(png);
    }
}

TEST_CASE("few bits and palettes read the same") {
    Random random(5);
    for (const int colorType : {0, 3}) {
        for (const int bits : {1, 2, 4, 8}) {
            CAPTURE(colorType);
            CAPTURE(bits);
            PngFile png;
            png.width = 13;
            png.height = 5;
            png.bits = bits;
            png.colorType = colorType;
            if (colorType == 3) {
                std::string colors;
                for (int i = 0; i < 3 << bits; ++i) colors += char(below(random, 256));
                png.before = pngChunk("PLTE", colors) + pngChunk("tRNS", "\x80");
            }
            std::string rows;
            for (std::uint32_t y = 0; y < png.height; ++y) {
                rows += '\0';
                for (int i = 0; i < (13 * bits + 7) / 8; ++i) rows += char(below(random, 256));
            }
            png.packed = zlibStream(rows);
            checkReadsTheSame(png);
        }
    }
}

TEST_CASE("interlaced files are left to OpenImageIO") {
    PngFile png = smallPng();
    png.interlace = 1;
    CHECK(isLeftToOpenImageIO(png));
}

TEST_CASE("pixels that lack, do not unpack, have no such filter or are too many are refused") {
    PngFile png = smallPng();
    const std::string whole = png.packed;
    png.packed = zlibStream(std::string(2 * (1 + png.rowBytes()) - 1, '\0'));
    CHECK(refusal(png) == ": PNG: Not enough image data");
    png.packed = whole.substr(0, 4);
    CHECK(refusal(png) == ": PNG: Not enough image data");
    png.packed = "";
    CHECK(refusal(png) == ": PNG: Not enough image data");
    png.packed = std::string(100, '\xff');
    CHECK(refusal(png) == ": PNG: IDAT: invalid window size (libpng)");
    png.packed = zlibStream(std::string(2 * (1 + png.rowBytes()), '\5'));
    CHECK(refusal(png) == ": PNG: bad adaptive filter value");
    png.colorType = 5;
    CHECK(refusal(png) == ": PNG: Invalid IHDR data");
    png.colorType = 2;
    png.width = kLargestSide + 1;
    CHECK(refusal(png) == ": a side of more than 131072 pixels");
    png.width = 0;
    CHECK(refusal(png) == ": PNG: Invalid IHDR data");
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
        CHECK((said == "none" || said.starts_with(": PNG: ")));
    }
}
