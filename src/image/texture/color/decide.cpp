#include "texture/color/decide.h"

#include "texture/color/code_points.h"
#include "texture/color/icc_profile.h"
#include "texture/color/lab_and_inks.h"
#include "texture/select/channel_names.h"

#include <specbake/core/error.h>

#include <cmath>

namespace specbake::internal {
namespace {

using Found = std::optional<ColorMeaning>;

ColorMeaning meaning(ColorSpace space, ColorSource source, std::string reason) {
    ColorMeaning m;
    m.space = std::move(space);
    m.source = source;
    m.reason = std::move(reason);
    return m;
}

/// X, Y and Z, or Lab, which leave no choice.
Found fromChannels(const ImageDescription& image, std::vector<std::string>& notes) {
    const auto& names = image.channels;
    if (names.size() >= 3 && sameName(names[0], "X") && sameName(names[1], "Y") &&
        sameName(names[2], "Z")) {
        return meaning(*findColorSpace("xyz"), ColorSource::channels, "channels X, Y, Z");
    }
    if (!isLab(image.signs.model)) return {};
    ColorMeaning lab =
        meaning(*findColorSpace("lin_prophoto"), ColorSource::channels, "CIE L*a*b* beside D50");
    if (image.sampleType != TexelType::uint8 && image.sampleType != TexelType::uint16) {
        lab.problem = "Lab of other than 8 or 16 bits is not read";
    }
    lab.transform = transformOfLab(image.signs.model, image.sampleType);
    if (!image.signs.icc.empty()) notes.emplace_back("its ICC profile is not used: Lab needs none");
    return lab;
}

Found fromProfile(const ImageDescription& image, std::vector<std::string>& notes) {
    if (image.signs.icc.empty()) return {};
    try {
        const int colors = int(image.channels.size()) - (image.alpha ? 1 : 0);
        return meaningOfProfile(image.signs.icc, image.signs.model, colors);
    } catch (const ProfileError& error) {
        notes.push_back(std::string("its ICC profile is not used: ") + error.what());
        return {};
    }
}

std::string written(const CodePoints& p) {
    return std::to_string(p.primaries) + "-" + std::to_string(p.transfer) + "-" +
           std::to_string(p.matrix) + "-" + (p.fullRange ? "1" : "0");
}

Found fromCodePoints(const ColorSigns& signs, std::vector<std::string>& notes) {
    if (!signs.cicp) return {};
    const std::string text = "cICP " + written(*signs.cicp);
    if (isHighDynamicRange(*signs.cicp)) {
        ColorMeaning m = meaning(*findColorSpace("rec2020"), ColorSource::cicp, text);
        m.problem = "its " + text +
                    " chunk says PQ or HLG: light of a display, not reflectance; "
                    "convert it, or say with --space what its numbers mean";
        return m;
    }
    std::string problem;
    if (const auto space = spaceOf(*signs.cicp, problem)) {
        return meaning(*space, ColorSource::cicp, text);
    }
    notes.push_back("its " + text + " chunk is not used: " + problem);
    return {};
}

/// Whether sRGB's own chromaticities are said, or none.
bool hasPrimariesOfSRGB(const ColorSigns& signs) {
    return !signs.chromaticities ||
           colorSpaceFromPrimaries(*signs.chromaticities).name == "lin_rec709";
}

/// 45455 is what the PNG specification has writers of sRGB put into gAMA, beside the sRGB chunk
/// that older ones did not know. No other writer means a pure power by it.
bool isGammaOfSRGB(double gamma) {
    return std::abs(gamma - 0.45455) < 5e-5;
}

Found fromSRGBChunk(const ColorSigns& signs, std::vector<std::string>& notes) {
    if (!signs.srgb) return {};
    if (signs.gamma && !isGammaOfSRGB(*signs.gamma)) {
        notes.emplace_back("its gAMA chunk is not used: the sRGB chunk says otherwise");
    }
    if (!hasPrimariesOfSRGB(signs)) {
        notes.emplace_back("its cHRM chunk is not used: the sRGB chunk says otherwise");
    }
    return meaning(*findColorSpace("srgb"), ColorSource::srgbChunk, "sRGB chunk");
}

/// Primaries that cannot be used are left aside.
std::optional<Primaries> usable(const std::optional<Primaries>& primaries,
                                std::vector<std::string>& notes) {
    if (!primaries) return {};
    try {
        return primariesFromText(primariesText(*primaries));
    } catch (const ArgumentError& error) {
        notes.push_back(std::string("its chromaticities are not used: ") + error.what());
        return {};
    }
}

Found fromGamma(const ColorSigns& signs, std::vector<std::string>& notes) {
    if (!signs.gamma) return {};
    const auto primaries = usable(signs.chromaticities, notes);
    const Transfer transfer = isGammaOfSRGB(*signs.gamma) ? Transfer::sRGB
                              : *signs.gamma == 1         ? Transfer::linear
                                                          : Transfer::power(1 / *signs.gamma);
    if (!(transfer.gamma >= 0.1 && transfer.gamma <= 10)) {
        notes.emplace_back("its gAMA chunk is not used: an exponent beyond 10");
        return {};
    }
    const Primaries& rec709 = *findColorSpace("srgb")->primaries;
    return meaning(colorSpaceFromPrimaries(primaries.value_or(rec709), transfer),
                   ColorSource::gamma, primaries ? "gAMA and cHRM chunks" : "gAMA chunk");
}

Found fromChromaticities(const ImageDescription& image, std::vector<std::string>& notes) {
    const auto primaries = usable(image.signs.chromaticities, notes);
    if (!primaries) return {};
    const Transfer& transfer = image.integers ? Transfer::sRGB : Transfer::linear;
    return meaning(colorSpaceFromPrimaries(*primaries, transfer), ColorSource::chromaticities,
                   "chromaticities");
}

ColorMeaning byDefault(const ImageDescription& image) {
    const bool integer = image.integers;
    return meaning(*findColorSpace(integer ? "srgb" : "lin_rec709"), ColorSource::sampleType,
                   integer ? "the file says nothing: integers are sRGB"
                           : "the file says nothing: floats are linear");
}

/// Inks have a meaning by their profile alone. Without, they are mixed as if they were filters.
void mixInks(const ImageDescription& image, ColorMeaning& m, std::vector<std::string>& notes) {
    if (!isInks(image.signs.model) || m.transform) return;
    notes.emplace_back(
        "CMYK without an ICC profile that can be used: a guess, as the product of what each ink "
        "leaves");
    m.transform = transformOfInks(image.signs.model, m.space.transfer);
    if (m.source == ColorSource::sampleType) m.reason = "CMYK without a profile: a guess";
}

}  // namespace

ColorMeaning meaningOf(const ImageDescription& image, std::vector<std::string>& notes) {
    Found found = fromChannels(image, notes);
    if (!found) found = fromCodePoints(image.signs, notes);
    if (!found) found = fromProfile(image, notes);
    if (!found) found = fromSRGBChunk(image.signs, notes);
    if (!found) found = fromGamma(image.signs, notes);
    if (!found) found = fromChromaticities(image, notes);
    ColorMeaning m = found ? std::move(*found) : byDefault(image);
    mixInks(image, m, notes);
    return m;
}

}  // namespace specbake::internal
