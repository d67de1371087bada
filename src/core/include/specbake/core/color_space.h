#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>
#include <specbake/core/transfer.h>

#include <Imath/ImathMatrix.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace specbake {

/// A colour space that a texture may be in: an RGB space by its primaries, or XYZ itself.
struct ColorSpace {
    std::string name;
    Transfer transfer;
    std::optional<Primaries> primaries;  ///< none: the three channels are X, Y, Z
    /// The light under which its colours hold unless another is named (observer.h): the space's
    /// white, or where no illuminant has that white (DCI-P3) the one that takes its place.
    std::string illuminant;

    bool isXYZ() const { return !primaries; }
};

/// Every space that `--space` offers, in the order in which help lists them. Their names are those
/// of color-interop-forum and OpenColorIO's ACES configurations as far as there are any.
SPECBAKE_API const std::vector<ColorSpace>& colorSpaces();

/// Other names of a space of colorSpaces(), as documents show them.
SPECBAKE_API std::vector<std::string> colorSpaceAliases(const ColorSpace& space);

/// The space of that name or alias, or nullptr. Letters and digits count, in any case: `Rec.709`
/// is `rec709`, `sRGB - Texture` is `srgb_texture`.
SPECBAKE_API const ColorSpace* findColorSpace(std::string_view name);

/// The same. Throws ArgumentError for an unknown name, and says which known one is near.
SPECBAKE_API const ColorSpace& colorSpaceNamed(std::string_view name);

/// The space with these primaries and that curve: a known one where they agree to 4 decimals, else
/// one named "custom" whose illuminant is the offered one nearest in chromaticity.
SPECBAKE_API ColorSpace colorSpaceFromPrimaries(const Primaries& primaries,
                                                const Transfer& transfer = Transfer::linear);

/// Primaries from `rx,ry,gx,gy,bx,by,wx,wy`, or from the name of a space that has some. Throws
/// ArgumentError.
SPECBAKE_API Primaries primariesFromText(std::string_view text);
/// Those eight numbers, which read back as the same.
SPECBAKE_API std::string primariesText(const Primaries& primaries);

/// XYZ from linear RGB: row i is the tristimulus of primary i, so that XYZ(rgb * matrix).
/// (1, 1, 1) goes to `white`. Identity for XYZ.
/// Throws ArgumentError if the primaries lie on one line.
SPECBAKE_API Imath::M33d xyzFromRGB(const ColorSpace& space, const XYZ& white);

}  // namespace specbake
