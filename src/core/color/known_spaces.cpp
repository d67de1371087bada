#include "color/names.h"

#include <specbake/core/color_space.h>
#include <specbake/core/error.h>

#include <algorithm>
#include <array>

namespace specbake {

using namespace internal;

namespace {

constexpr Chromaticity kD65{0.3127, 0.3290};
constexpr Chromaticity kD50{0.3457, 0.3585};
constexpr Chromaticity kAces{0.32168, 0.33767};
constexpr Chromaticity kTheatre{0.314, 0.351};  // SMPTE RP 431-2: no CIE illuminant has it
constexpr Primaries kRec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, kD65};
constexpr Primaries kP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kD65};
constexpr Primaries kDciP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kTheatre};
constexpr Primaries kAdobe{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, kD65};
constexpr Primaries kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65};
constexpr Primaries kAp1{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, kAces};
constexpr Primaries kAp0{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, kAces};
constexpr Primaries kRomm{{0.7347, 0.2653}, {0.1596, 0.8404}, {0.0366, 0.0001}, kD50};

constexpr Transfer kAdobeGamma = Transfer::power(563.0 / 256);  // Adobe RGB (1998), 4.3.4.2

/// Other names, of which letters and digits count: those of OpenColorIO's ACES configurations
/// (with their aliases), of OpenImageIO, and of people.
struct Alias {
    const char* alias;
    const char* name;
};
constexpr std::array kAliases = std::to_array<Alias>({
    {"sRGB - Texture", "srgb"},
    {"srgb_texture", "srgb"},
    {"srgb_tx", "srgb"},
    {"srgb_rec709", "srgb"},
    {"srgb_rec709_scene", "srgb"},
    {"srgb_display", "srgb"},
    {"sRGB Encoded Rec.709 (sRGB)", "srgb"},
    {"Utility - sRGB - Texture", "srgb"},
    {"Input - Generic - sRGB - Texture", "srgb"},
    {"BT.709", "rec709"},
    {"Camera Rec.709", "rec709"},
    {"BT.2020", "rec2020"},
    {"p3d65_srgb", "displayp3"},
    {"Display P3 - Display", "displayp3"},
    {"srgb_displayp3", "displayp3"},
    {"srgb_p3d65", "displayp3"},
    {"srgb_p3d65_scene", "displayp3"},
    {"sRGB Encoded P3-D65", "displayp3"},
    {"sRGB Encoded P3-D65 - Texture", "displayp3"},
    {"DCI-P3", "dcip3"},
    {"P3-DCI", "dcip3"},
    {"Adobe RGB (1998)", "adobergb"},
    {"g22_adobergb", "adobergb"},
    {"Gamma 2.2 Encoded AdobeRGB", "adobergb"},
    {"romm", "prophoto"},
    {"ROMM RGB", "prophoto"},
    {"ProPhoto RGB", "prophoto"},
    {"g18_rec709_tx", "g18_rec709"},
    {"g18_rec709_scene", "g18_rec709"},
    {"Gamma 1.8 Rec.709 - Texture", "g18_rec709"},
    {"Gamma 1.8 Encoded Rec.709", "g18_rec709"},
    {"g22_rec709_tx", "g22_rec709"},
    {"g22_rec709_scene", "g22_rec709"},
    {"Gamma 2.2 Rec.709 - Texture", "g22_rec709"},
    {"Gamma 2.2 Encoded Rec.709", "g22_rec709"},
    {"g24_rec709_tx", "g24_rec709"},
    {"Gamma 2.4 Rec.709 - Texture", "g24_rec709"},
    {"Gamma 2.4 Encoded Rec.709", "g24_rec709"},
    {"rec709_display", "g24_rec709"},
    {"rec1886_rec709_display", "g24_rec709"},
    {"Rec.1886 Rec.709 - Display", "g24_rec709"},
    {"srgb_encoded_ap1_tx", "srgb_ap1"},
    {"srgb_ap1_scene", "srgb_ap1"},
    {"sRGB Encoded AP1", "srgb_ap1"},
    {"sRGB Encoded AP1 - Texture", "srgb_ap1"},
    {"g22_ap1_tx", "g22_ap1"},
    {"g22_ap1_scene", "g22_ap1"},
    {"Gamma 2.2 AP1 - Texture", "g22_ap1"},
    {"Gamma 2.2 Encoded AP1", "g22_ap1"},
    {"linear", "lin_rec709"},
    {"scene_linear", "lin_rec709"},
    {"lin_srgb", "lin_rec709"},
    {"lin_rec709_scene", "lin_rec709"},
    {"lin_rec709_srgb", "lin_rec709"},
    {"Linear Rec.709 (sRGB)", "lin_rec709"},
    {"Linear sRGB", "lin_rec709"},
    {"Utility - Linear - sRGB", "lin_rec709"},
    {"Utility - Linear - Rec.709", "lin_rec709"},
    {"lin_p3d65", "lin_displayp3"},
    {"lin_p3d65_scene", "lin_displayp3"},
    {"Linear P3-D65", "lin_displayp3"},
    {"Linear Display P3", "lin_displayp3"},
    {"Utility - Linear - P3-D65", "lin_displayp3"},
    {"Linear DCI-P3", "lin_dcip3"},
    {"lin_adobergb_scene", "lin_adobergb"},
    {"Linear AdobeRGB", "lin_adobergb"},
    {"lin_rec2020_scene", "lin_rec2020"},
    {"Linear Rec.2020", "lin_rec2020"},
    {"Linear BT.2020", "lin_rec2020"},
    {"Utility - Linear - Rec.2020", "lin_rec2020"},
    {"lin_ap1", "acescg"},
    {"lin_ap1_scene", "acescg"},
    {"ACES - ACEScg", "acescg"},
    {"aces", "aces2065-1"},
    {"lin_ap0", "aces2065-1"},
    {"lin_ap0_scene", "aces2065-1"},
    {"ACES - ACES2065-1", "aces2065-1"},
    {"lin_prophotorgb", "lin_prophoto"},
    {"lin_romm", "lin_prophoto"},
    {"Linear ProPhoto RGB", "lin_prophoto"},
    {"CIE-XYZ", "xyz"},
});

const ColorSpace* spaceOfBareName(std::string_view bare) {
    for (const ColorSpace& space : colorSpaces()) {
        if (bareName(space.name) == bare) return &space;
    }
    return nullptr;
}

}  // namespace

const std::vector<ColorSpace>& colorSpaces() {
    static const std::vector<ColorSpace> spaces = {
        {"srgb", Transfer::sRGB, kRec709, "D65"},
        {"rec709", Transfer::rec709, kRec709, "D65"},
        {"g18_rec709", Transfer::power(1.8), kRec709, "D65"},
        {"g22_rec709", Transfer::power(2.2), kRec709, "D65"},
        {"g24_rec709", Transfer::power(2.4), kRec709, "D65"},
        {"displayp3", Transfer::sRGB, kP3, "D65"},
        {"dcip3", Transfer::power(2.6), kDciP3, "D65"},
        {"adobergb", kAdobeGamma, kAdobe, "D65"},
        {"rec2020", Transfer::rec709, kRec2020, "D65"},
        {"prophoto", Transfer::romm, kRomm, "D50"},
        {"srgb_ap1", Transfer::sRGB, kAp1, "D60"},
        {"g22_ap1", Transfer::power(2.2), kAp1, "D60"},
        {"lin_rec709", Transfer::linear, kRec709, "D65"},
        {"lin_displayp3", Transfer::linear, kP3, "D65"},
        {"lin_dcip3", Transfer::linear, kDciP3, "D65"},
        {"lin_adobergb", Transfer::linear, kAdobe, "D65"},
        {"lin_rec2020", Transfer::linear, kRec2020, "D65"},
        {"acescg", Transfer::linear, kAp1, "D60"},
        {"aces2065-1", Transfer::linear, kAp0, "D60"},
        {"lin_prophoto", Transfer::linear, kRomm, "D50"},
        {"xyz", Transfer::linear, std::nullopt, "E"},
    };
    return spaces;
}

std::vector<std::string> colorSpaceAliases(const ColorSpace& space) {
    std::vector<std::string> aliases;
    for (const Alias& alias : kAliases) {
        if (alias.name == space.name) aliases.emplace_back(alias.alias);
    }
    return aliases;
}

const ColorSpace* findColorSpace(std::string_view name) {
    const std::string bare = bareName(name);
    if (const ColorSpace* space = spaceOfBareName(bare)) return space;
    const auto alias = std::find_if(kAliases.begin(), kAliases.end(),
                                    [&](const Alias& a) { return bareName(a.alias) == bare; });
    return alias == kAliases.end() ? nullptr : spaceOfBareName(bareName(alias->name));
}

const ColorSpace& colorSpaceNamed(std::string_view name) {
    if (const ColorSpace* space = findColorSpace(name)) return *space;
    std::vector<std::string> names;
    for (const ColorSpace& space : colorSpaces()) names.push_back(space.name);
    for (const Alias& alias : kAliases) names.emplace_back(alias.alias);
    throw ArgumentError("unknown colour space '" + std::string(name) + "'" +
                        suggestion(name, names));
}

}  // namespace specbake
