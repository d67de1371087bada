#include "color/names.h"

#include <specbake/core/color_space.h>
#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <string>

using namespace specbake;
using namespace specbake::internal;

namespace {

std::string complaint(const std::string& name) {
    try {
        static_cast<void>(colorSpaceNamed(name));
    } catch (const ArgumentError& error) {
        return error.what();
    }
    return "none";
}

bool suggests(const std::string& typed, const std::string& meant) {
    return complaint(typed).find("did you mean '" + meant + "'?") != std::string::npos;
}

}  // namespace

TEST_CASE("spaces have the names that people and other programs give them") {
    const std::pair<const char*, const char*> names[] = {
        {"sRGB", "srgb"},
        {"srgb_texture", "srgb"},
        {"srgb_tx", "srgb"},
        {"sRGB - Texture", "srgb"},
        {"Utility - sRGB - Texture", "srgb"},
        {"lin_srgb", "lin_rec709"},
        {"linear", "lin_rec709"},
        {"scene_linear", "lin_rec709"},
        {"Linear Rec.709 (sRGB)", "lin_rec709"},
        {"ACEScg", "acescg"},
        {"lin_ap1_scene", "acescg"},
        {"ACES - ACEScg", "acescg"},
        {"ACES2065-1", "aces2065-1"},
        {"lin_ap0", "aces2065-1"},
        {"Rec.709", "rec709"},
        {"BT.709", "rec709"},
        {"Rec.2020", "rec2020"},
        {"Display P3", "displayp3"},
        {"P3-DCI", "dcip3"},
        {"Adobe RGB (1998)", "adobergb"},
        {"ProPhoto RGB", "prophoto"},
        {"ROMM RGB", "prophoto"},
        {"g22_rec709", "g22_rec709"},
        {"Gamma 2.2 Encoded Rec.709", "g22_rec709"},
        {"XYZ", "xyz"}};
    for (const auto& [typed, meant] : names) {
        CAPTURE(typed);
        REQUIRE(findColorSpace(typed) != nullptr);
        CHECK(findColorSpace(typed)->name == meant);
        CHECK(colorSpaceNamed(typed).name == meant);
    }
}

TEST_CASE("no name or alias means two spaces, and case and punctuation do not count") {
    std::map<std::string, std::string> owner;
    for (const ColorSpace& space : colorSpaces()) {
        std::vector<std::string> all = colorSpaceAliases(space);
        all.push_back(space.name);
        for (const std::string& name : all) {
            CAPTURE(name);
            const auto known = owner.emplace(bareName(name), space.name).first;
            CHECK(known->second == space.name);
            CHECK(colorSpaceNamed(name).name == space.name);
            std::string odd = " ";
            for (const char c : name) odd += c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
            CHECK(colorSpaceNamed(odd + "_").name == space.name);
        }
    }
}

TEST_CASE("a slip of the keyboard is told the space that was meant") {
    CHECK(suggests("AECScg", "acescg"));
    CHECK(suggests("srbg", "srgb"));
    CHECK(suggests("adobe_rbg", "adobergb"));
    CHECK(suggests("rec.790", "rec709"));
    CHECK(suggests("lin_rec7O9", "lin_rec709"));
    CHECK(suggests("prophot", "prophoto"));
    for (const char* text : {"", "?", "qwertyuiopas", "auto"}) {
        CAPTURE(text);
        CHECK(complaint(text).find("unknown colour space") == 0);
        CHECK(complaint(text).find("did you mean") == std::string::npos);
    }
    CHECK(complaint(std::string(1 << 20, 'a')).find("did you mean") == std::string::npos);
}

TEST_CASE("what differs from a name in one letter is that name, or suggests one as near") {
    std::mt19937 random(4);
    const auto below = [&](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    for (const ColorSpace& space : colorSpaces()) {
        for (int i = 0; i < 50; ++i) {
            std::string typed = space.name;
            const char letter = "abcdefghijklmnopqrstuvwxyz0123456789"[below(36)];
            if (i % 3 == 0)
                typed.insert(typed.begin() + std::ptrdiff_t(below(typed.size())), letter);
            if (i % 3 == 1) typed[below(typed.size())] = letter;
            if (i % 3 == 2) typed.erase(below(typed.size()), 1);
            CAPTURE(typed);
            if (findColorSpace(typed) != nullptr) continue;
            if (bareName(typed).size() < 3) continue;  // too little to tell what was meant
            CHECK(complaint(typed).find("did you mean '") != std::string::npos);
        }
    }
}

TEST_CASE("primaries: by name, by numbers, and read back to the last bit") {
    CHECK(primariesFromText("Adobe RGB (1998)") == *findColorSpace("adobergb")->primaries);
    CHECK(primariesFromText("0.64, 0.33,0.3,0.6,0.15,0.06,0.3127,0.329") ==
          *findColorSpace("srgb")->primaries);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> noise(-0.05, 0.05);
    const auto near = [&](double x, double y) {
        return Chromaticity{x + noise(random), y + noise(random)};
    };
    for (int i = 0; i < 1000; ++i) {
        const Primaries p{near(0.64, 0.33), near(0.3, 0.6), near(0.15, 0.06), near(0.31, 0.33)};
        CHECK(primariesFromText(primariesText(p)) == p);
    }
    for (const char* text :
         {"", "xyz", "nonsense", "0.64,0.33,0.3,0.6,0.15,0.06,0.3127", "1,2,3,4,5,6,7,8,9",
          "0.64,0.33,0.3,0.6,0.15,0.06,0.3127,0", "nan,0.33,0.3,0.6,0.15,0.06,0.3127,0.329",
          "0.1,0.1,0.2,0.2,0.3,0.3,0.3,0.3", "inf,0.33,0.3,0.6,0.15,0.06,0.3127,0.329"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(primariesFromText(text), ArgumentError);
    }
}
