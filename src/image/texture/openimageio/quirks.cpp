#include "texture/openimageio/quirks.h"

#include "texture/image_file.h"

#include <specbake/core/error.h>

#include <array>
#include <string_view>

namespace specbake::internal {
namespace {

/// The last channel is alpha, whatever its number is said to be.
void alphaIsLast(OIIO::ImageSpec& spec) {
    if (spec.nchannels == 2 || spec.nchannels == 4) spec.alpha_channel = spec.nchannels - 1;
}

/// Colour is stored as it is, and the reader leaves it so without saying it.
void alphaIsStraight(OIIO::ImageSpec& spec) {
    spec["oiio:UnassociatedAlpha"] = 1;
}

void straightAlphaIsLast(OIIO::ImageSpec& spec) {
    alphaIsLast(spec);
    alphaIsStraight(spec);
}

/// Alpha is what comes behind four inks, if the file says that it is alpha; never the fourth.
void alphaIsBehindInks(OIIO::ImageSpec& spec) {
    constexpr int separated = 5;  // TIFF 6.0, section 16
    if (spec.get_int_attribute("tiff:PhotometricInterpretation") != separated) return;
    const bool said = spec.get_int_attribute("tiff:UnassociatedAlpha") != 0;
    if (spec.nchannels > 3) spec.alpha_channel = spec.nchannels > 4 && said ? 4 : -1;
    if (said) alphaIsStraight(spec);
}

struct Quirk {
    std::string_view format;  ///< ImageInput::format_name()
    std::string_view seenIn;  ///< the version of OpenImageIO; not who has it first or last
    std::string_view what;
    void (*correct)(OIIO::ImageSpec& spec);
    const char* remark = nullptr;  ///< for a user, where there is alpha
};

constexpr std::array<Quirk, 10> kQuirks = {{
    {"gif", "2.4.7", "alpha_channel is 4, of 4 channels; alpha is 0 or 1", straightAlphaIsLast},
    {"bmp", "2.4.7", "straight alpha as stored, without a word", alphaIsStraight},
    {"ico", "2.4.7", "straight alpha as stored, without a word", alphaIsStraight},
    {"jpeg2000", "2.4.7", "straight alpha as stored, without a word", alphaIsStraight},
    {"psd", "2.4.7", "made straight on demand, without a word", alphaIsStraight,
     "its composite is mixed with white in 8 bits: colours are rounded the more, the smaller alpha "
     "is, and black where it is 0"},
    {"sgi", "2.4.7", "straight alpha as stored, without a word", alphaIsStraight},
    {"dds", "2.4.7", "straight alpha as stored, without a word", alphaIsStraight},
    {"heif", "2.4.7", "straight alpha as stored, without a word", alphaIsStraight},
    {"tiff", "2.4.7", "of C, M, Y, K the last is alpha; behind five inks there is none",
     alphaIsBehindInks},
    {"webp", "2.4.7", "multiplies by alpha in 8 bits, whatever is asked", alphaIsLast,
     "OpenImageIO's reader multiplies it by alpha in 8 bits: colours are rounded the more, the "
     "smaller alpha is, and black where it is 0"},
}};

}  // namespace

std::vector<std::string> correctQuirks(const std::string& format, OIIO::ImageSpec& spec) {
    std::vector<std::string> remarks;
    for (const Quirk& quirk : kQuirks) {
        if (quirk.format != format) continue;
        quirk.correct(spec);
        if (quirk.remark != nullptr && spec.alpha_channel >= 0) remarks.emplace_back(quirk.remark);
    }
    return remarks;
}

void checkConsistency(const std::string& path, OIIO::ImageSpec& spec) {
    constexpr int mostChannels = 1024;
    if (spec.deep) throw FileError(path, "deep images are not textures");
    if (spec.depth > 1) throw FileError(path, "volumes are not textures");
    checkSides(path, spec.width, spec.height);
    if (isFarOut({spec.x, spec.y, spec.width, spec.height}) ||
        isFarOut({spec.full_x, spec.full_y, spec.full_width, spec.full_height})) {
        throw FileError(path, "a window too far from the origin");
    }
    if (spec.nchannels < 1 || spec.nchannels > mostChannels) {
        throw FileError(path, std::to_string(spec.nchannels) + " channels; 1 to " +
                                  std::to_string(mostChannels) + " can be read");
    }
    const bool tiled = spec.tile_width != 0 || spec.tile_height != 0;
    if (tiled && (spec.tile_width < 1 || spec.tile_height < 1 || spec.tile_width > kLargestSide ||
                  spec.tile_height > kLargestSide)) {
        throw FileError(path, "tiles of impossible size, or of more than " +
                                  std::to_string(kLargestSide) + " pixels");
    }
    if (spec.format.size() == 0 || spec.format.is_array()) {
        throw FileError(path, "samples of an unknown type");
    }
    if (spec.alpha_channel >= spec.nchannels) spec.alpha_channel = -1;
}

}  // namespace specbake::internal
