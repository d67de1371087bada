#include "texture/data_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace specbake::internal {
namespace {

struct Meaning {
    std::string_view word;
    std::string_view data;
};

constexpr std::array<Meaning, 31> kData = {{{"normal", "normals"},
                                            {"normals", "normals"},
                                            {"normalgl", "normals"},
                                            {"normaldx", "normals"},
                                            {"nrm", "normals"},
                                            {"nor", "normals"},
                                            {"norm", "normals"},
                                            {"rough", "roughness"},
                                            {"roughness", "roughness"},
                                            {"gloss", "glossiness"},
                                            {"glossiness", "glossiness"},
                                            {"metal", "metalness"},
                                            {"metallic", "metalness"},
                                            {"metalness", "metalness"},
                                            {"ao", "occlusion"},
                                            {"occlusion", "occlusion"},
                                            {"ambientocclusion", "occlusion"},
                                            {"arm", "occlusion, roughness and metalness"},
                                            {"orm", "occlusion, roughness and metalness"},
                                            {"disp", "heights"},
                                            {"displacement", "heights"},
                                            {"height", "heights"},
                                            {"bump", "heights"},
                                            {"depth", "depths"},
                                            {"mask", "a mask"},
                                            {"opacity", "opacity"},
                                            {"position", "positions"},
                                            {"uv", "coordinates"},
                                            {"flow", "directions"},
                                            {"tangent", "directions"},
                                            {"curvature", "curvature"}}};

constexpr std::array<std::string_view, 10> kColors = {
    "diff",   "diffuse", "albedo",    "col",        "color",
    "colour", "base",    "basecolor", "basecolour", "rgb"};

/// The words of a name, in small letters.
std::vector<std::string> wordsOf(const std::string& name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) == 0) {
            words.emplace_back();
        } else {
            words.back() += char(std::tolower(letter));
        }
    }
    std::erase(words, "");
    return words;
}

const Meaning* meaningOf(const std::string& word) {
    const auto found =
        std::find_if(kData.begin(), kData.end(), [&](const Meaning& m) { return m.word == word; });
    return found == kData.end() ? nullptr : &*found;
}

bool isColor(const std::string& word) {
    return std::find(kColors.begin(), kColors.end(), word) != kColors.end();
}

/// The space that a word, or two that follow each other, are a name of. Names that are ordinary
/// words, too, and those of three letters say nothing.
const ColorSpace* spaceIn(const std::vector<std::string>& words) {
    constexpr std::array<std::string_view, 4> ordinary = {"aces", "romm", "linear", "scenelinear"};
    for (std::size_t count : {2U, 1U}) {
        for (std::size_t i = 0; i + count <= words.size(); ++i) {
            const std::string name = words[i] + (count == 2 ? words[i + 1] : "");
            const bool counts = name.size() > 3 &&
                                std::find(ordinary.begin(), ordinary.end(), name) == ordinary.end();
            const ColorSpace* space = counts ? findColorSpace(name) : nullptr;
            if (space != nullptr) return space;
        }
    }
    return nullptr;
}

}  // namespace

std::optional<std::string> remarkOnSpace(const std::string& path, const ColorSpace& taken) {
    const ColorSpace* space = spaceIn(wordsOf(std::filesystem::path(path).stem().string()));
    if (space == nullptr || space->name == taken.name) return {};
    return "its name says " + space->name + ", but nothing in it does: it is taken for " +
           taken.name + " (--space " + space->name + " says otherwise)";
}

std::optional<std::string> remarkOnName(const std::string& path) {
    const std::vector<std::string> words = wordsOf(std::filesystem::path(path).stem().string());
    if (std::any_of(words.begin(), words.end(), isColor)) return {};
    // The first word names the thing, unless it is the only one: metal_plate_02.png is a colour.
    const std::span rest = std::span(words).subspan(words.size() > 1 ? 1 : 0);
    for (const std::string& word : rest) {
        if (const Meaning* meaning = meaningOf(word)) {
            return "its name says that it holds " + std::string(meaning->data) +
                   ": a bake makes spectra of them, as if they were colours";
        }
    }
    return {};
}

}  // namespace specbake::internal
