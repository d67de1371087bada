#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color_space.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace specbake {

/// The kind of numbers that a pixel's channels of colour hold.
enum class ColorModel {
    rgb,          ///< or grey, or X, Y, Z
    cmyk,         ///< amounts of ink
    cmykOnPaper,  ///< the same stored as what ink leaves: 1 - amount
    cieLab,       ///< TIFF 6.0, section 23: a and b signed
    iccLab,       ///< Adobe's TIFF notes, 2002: a and b with an offset
};

/// Who says what a texture's numbers mean.
enum class ColorSource {
    user,            ///< or who hands over an image in memory
    config,          ///< a configuration of OpenColorIO, named by the user
    icc,             ///< the file's ICC profile
    cicp,            ///< PNG: cICP, code points of ITU-T H.273
    srgbChunk,       ///< PNG: sRGB
    gamma,           ///< PNG: gAMA, cHRM or both
    chromaticities,  ///< EXR, TIFF
    channels,        ///< what the channels are called, or the kind of their colours
    sampleType,      ///< nobody: integers are sRGB, floats linear Rec.709
};

/// "user", "ocio", "icc", "cicp", "srgb", "gama", "chromaticities", "channels", "default".
SPECBAKE_API std::string_view colorSourceName(ColorSource source);

/// Stored pixels to linear colours, where no curve for each channel does it: four inks, Lab, a
/// profile with tables. Immutable; any number of threads may share one.
class SPECBAKE_API PixelTransform {
  public:
    PixelTransform() = default;
    virtual ~PixelTransform();
    PixelTransform(const PixelTransform&) = delete;
    PixelTransform& operator=(const PixelTransform&) = delete;

    /// `count` pixels, each of the texture's channels of colour, as they are stored (integers as a
    /// share of their largest), to linear colours of the meaning's space.
    virtual void run(const float* stored, std::size_t count,
                     std::array<float, 3>* linear) const = 0;
};

/// How the three components become linear ones: values at i / 65535 for each.
inline constexpr std::size_t kCurveSize = 65536;
using SampledCurves = std::array<std::vector<float>, 3>;

/// What a texture's numbers mean, and who says so.
struct ColorMeaning {
    ColorSpace space;
    ColorSource source = ColorSource::user;
    std::string reason;   ///< for people: "ICC profile 'Adobe RGB (1998)'"
    std::string profile;  ///< a hash of the profile, where one takes part beside `space`
    /// Of ColorSource::config: what the configuration calls the numbers' space, and a hash of the
    /// way from there to `space`, tables included.
    std::string configSpace, configHash;
    std::string problem;  ///< why it cannot be used; empty if it can
    /// Instead of `space.transfer`, if there are any.
    std::shared_ptr<const SampledCurves> curves;
    /// Instead of both, if there is one.
    std::shared_ptr<const PixelTransform> transform;
};

/// What a user says of a texture's numbers; what is none is left to the texture.
struct ColorWishes {
    std::optional<std::string> space;      ///< of colorSpaces() or an alias of one
    std::optional<std::string> transfer;   ///< as transferFromName() reads it
    std::optional<std::string> primaries;  ///< as primariesFromText() reads it
    /// A configuration of OpenColorIO, a file: `space` is one of its spaces or roles if there is
    /// one of the name, and without `space` its file rules are asked first, all but the default
    /// one. `primaries` are then those of its role scene_linear, if no space of it says them.
    std::optional<std::string> config = {};

    /// Whether something is said of the numbers, by whatever `config` says.
    bool any() const { return space || transfer || primaries; }
    /// Whether they can be read. `reason`, if it is given, says why not: one line. Names of spaces
    /// that may be a configuration's are left to chosenMeaning().
    [[nodiscard]] SPECBAKE_API bool isValid(std::string* reason = nullptr) const;
};

/// The space that the wishes say, over one that is there without them. Throws ArgumentError for
/// wishes that cannot be read.
SPECBAKE_API ColorSpace wishedSpace(const ColorSpace& base, const ColorWishes& wishes);

/// What R, G and B mean that are of no texture: those of a space of the wishes' configuration, if
/// both are named and it has the space, else of the space that the wishes say, over `base`.
/// Throws ArgumentError for wishes that cannot be read, and FileError for the configuration.
SPECBAKE_API ColorMeaning meaningOfNumbers(const ColorSpace& base, const ColorWishes& wishes);

/// The space of the numbers without their curves: of a configuration's the one with its primaries
/// and its white. Throws ArgumentError where curves and primaries are not all that the meaning is.
SPECBAKE_API ColorSpace linearSpaceOf(const ColorMeaning& meaning);

struct TextureInfo;

/// The texture's own meaning, or what the user makes of it. `unused` gets a line for what the
/// texture says and the user overrules. Throws ArgumentError for wishes that cannot be read, and
/// FileError for a meaning that cannot be used.
SPECBAKE_API ColorMeaning chosenMeaning(const TextureInfo& texture, const ColorWishes& wishes,
                                        std::vector<std::string>& unused);

}  // namespace specbake
