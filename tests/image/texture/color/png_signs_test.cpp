#include "texture/color/png_signs.h"

#include "support/png_file.h"

#include <doctest/doctest.h>

#include <random>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

/// A chunk read into signs that were empty.
ColorSigns read(std::string_view name, const std::string& data, std::vector<std::string>& notes) {
    ColorSigns signs;
    readPngColorChunk(name, data, signs, notes);
    return signs;
}

std::string numbers(const std::vector<std::uint32_t>& values) {
    std::string data;
    for (const std::uint32_t value : values) data += bigEndian(value, 4);
    return data;
}

std::string profileChunk(const std::string& profile) {
    return std::string("any name\0\0", 10) + zlibStream(profile);
}

}  // namespace

TEST_CASE("PNG's colour chunks: what they hold") {
    std::vector<std::string> notes;
    const CodePoints p3{12, 13, 0, true};
    CHECK(read("cICP", std::string("\x0c\x0d\0\x01", 4), notes).cicp == p3);
    CHECK(read("gAMA", numbers({45455}), notes).gamma == 0.45455);
    CHECK(read("sRGB", std::string(1, '\0'), notes).srgb);
    // White comes first (PNG, 11.3.2.1).
    const auto primaries =
        read("cHRM", numbers({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000}), notes)
            .chromaticities;
    REQUIRE(primaries);
    CHECK(*primaries == *findColorSpace("srgb")->primaries);
    const std::string profile(100000, 'x');
    CHECK(read("iCCP", profileChunk(profile), notes).icc == profile);
    CHECK(notes.empty());
    CHECK(read("tEXt", "any", notes) == ColorSigns());
    CHECK(notes.empty());
}

TEST_CASE("damaged chunks of colour say nothing, and a line says so") {
    const std::pair<const char*, std::string> damaged[] = {
        {"cICP", std::string("\x0c\x0d\0", 3)},
        {"cICP", std::string("\x0c\x0d\0\x01\0", 5)},
        {"gAMA", std::string(3, '\x01')},
        {"gAMA", std::string(4, '\0')},
        {"gAMA", ""},
        {"cHRM", std::string(31, '\x01')},
        {"cHRM", std::string(33, '\x01')},
        {"sRGB", ""},
        {"sRGB", std::string(2, '\0')},
        {"iCCP", ""},
        {"iCCP", "name without an end"},
        {"iCCP", std::string(80, 'n') + '\0' + '\0' + zlibStream("x")},
        {"iCCP", std::string("name\0", 5)},
        {"iCCP", std::string("name\0\x01", 6) + zlibStream("x")},
        {"iCCP", std::string("name\0\0", 6) + "no zlib stream"},
        {"iCCP", std::string("name\0\0", 6) + zlibStream("")},
        {"iCCP", profileChunk(std::string(1000, 'x')).substr(0, 20)},
        {"iCCP", profileChunk(std::string(kLargestProfile + 1, '\0'))}};
    for (const auto& [name, data] : damaged) {
        CAPTURE(name);
        CAPTURE(data.size());
        std::vector<std::string> notes;
        CHECK(read(name, data, notes) == ColorSigns());
        REQUIRE(notes.size() == 1);
        CHECK(notes[0].find(name) != std::string::npos);
    }
}

TEST_CASE("20,000 chunks of chance never do more than that") {
    std::mt19937 random(1);
    const auto below = [&](int end) { return std::uniform_int_distribution(0, end - 1)(random); };
    const std::string good = profileChunk(std::string(500, 'x'));
    for (int i = 0; i < 20000; ++i) {
        std::string data = i % 2 == 0 ? good : std::string(std::size_t(below(64)), '\0');
        for (int changes = 1 + below(8); changes > 0 && !data.empty(); --changes) {
            data[std::size_t(below(int(data.size())))] = char(below(256));
        }
        data.resize(std::size_t(below(int(data.size()) + 1)));
        const char* name =
            std::array{"cICP", "iCCP", "sRGB", "gAMA", "cHRM"}[std::size_t(below(5))];
        std::vector<std::string> notes;
        const ColorSigns signs = read(name, data, notes);
        CHECK((signs == ColorSigns()) == (notes.size() == 1));
        CHECK(signs.icc.size() <= kLargestProfile);
    }
}
