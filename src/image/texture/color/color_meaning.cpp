#include "texture/color/lab_and_inks.h"
#include "texture/openimageio/openimageio_parts.h"

#include <specbake/core/error.h>
#include <specbake/image/color_meaning.h>
#include <specbake/image/texture.h>

namespace specbake {

using namespace internal;

namespace {

Transfer transferNamed(const std::string& name) {
    if (const auto transfer = transferFromName(name)) return *transfer;
    throw ArgumentError("unknown transfer curve '" + name +
                        "': linear, srgb, rec709, romm or gamma:NUMBER");
}

std::string written(const ColorWishes& wishes) {
    std::string text;
    const auto add = [&text](const char* option, const std::optional<std::string>& value) {
        if (!value) return;
        if (!text.empty()) text += ' ';
        text += option;
        text += ' ';
        text += *value;
    };
    add("--space", wishes.space);
    add("--transfer", wishes.transfer);
    add("--primaries", wishes.primaries);
    return text;
}

/// What is left of the texture's own meaning where the wishes do not say all.
ColorSpace baseOf(const TextureInfo& texture, const ColorWishes& wishes) {
    const ColorMeaning& own = texture.color;
    const bool tables = own.transform != nullptr || (own.curves && !wishes.transfer);
    if (!wishes.space && tables) {
        throw FileError(texture.path, own.reason + " has no part that " + written(wishes) +
                                          " could take the place of; --space says all");
    }
    return own.space;
}

}  // namespace

PixelTransform::~PixelTransform() = default;

std::string_view colorSourceName(ColorSource source) {
    switch (source) {
        case ColorSource::config:
            return "ocio";
        case ColorSource::icc:
            return "icc";
        case ColorSource::cicp:
            return "cicp";
        case ColorSource::srgbChunk:
            return "srgb";
        case ColorSource::gamma:
            return "gama";
        case ColorSource::chromaticities:
            return "chromaticities";
        case ColorSource::channels:
            return "channels";
        case ColorSource::sampleType:
            return "default";
        case ColorSource::user:
            break;
    }
    return "user";
}

ColorSpace wishedSpace(const ColorSpace& base, const ColorWishes& wishes) {
    const ColorSpace space = wishes.space ? colorSpaceNamed(*wishes.space) : base;
    if (!wishes.transfer && !wishes.primaries) return space;
    if (space.isXYZ()) throw ArgumentError("X, Y and Z have neither primaries nor a curve");
    const Transfer transfer = wishes.transfer ? transferNamed(*wishes.transfer) : space.transfer;
    return colorSpaceFromPrimaries(
        wishes.primaries ? primariesFromText(*wishes.primaries) : *space.primaries, transfer);
}

bool ColorWishes::isValid(std::string* reason) const {
    std::string problem;
    try {
        ColorWishes own = *this;
        if (config) own.space = {};
        static_cast<void>(wishedSpace(*findColorSpace("srgb"), own));
    } catch (const ArgumentError& error) {
        problem = error.what();
    }
    const bool valid = problem.empty();
    if (reason != nullptr) *reason = std::move(problem);
    return valid;
}

ColorMeaning chosenMeaning(const TextureInfo& texture, const ColorWishes& wishes,
                           std::vector<std::string>& unused) {
    const ColorMeaning& own = texture.color;
    if (wishes.config) {
        if (auto meaning = openImageIOParts(texture.path).meaningByConfig(texture, wishes)) {
            return *std::move(meaning);
        }
    }
    if (!wishes.any()) {
        if (!own.problem.empty()) throw FileError(texture.path, own.problem);
        return own;
    }
    if (isLab(texture.model)) {
        throw FileError(texture.path,
                        "Lab has a meaning of its own: leave " + written(wishes) + " out");
    }
    ColorMeaning meaning;
    meaning.space = wishedSpace(baseOf(texture, wishes), wishes);
    meaning.source = ColorSource::user;
    meaning.reason = written(wishes);
    if (isInks(texture.model)) {
        meaning.transform = transformOfInks(texture.model, meaning.space.transfer);
    }
    if (own.source != ColorSource::sampleType && own.source != ColorSource::user &&
        !(wishes.space && *wishes.space == own.space.name)) {
        unused.push_back("its own word is not used, as " + meaning.reason +
                         " says otherwise: " + own.reason + " (" + own.space.name + ")");
    }
    return meaning;
}

}  // namespace specbake
