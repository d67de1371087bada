#pragma once

#include <specbake/core/api.h>

#include <optional>
#include <string>
#include <string_view>

namespace specbake {

/// The curve by which a stored component becomes a linear one: a power above the knee, and a
/// straight line below it,
///
///     linear = encoded / slope                          up to `knee`,
///     linear = ((encoded + offset) / divisor) ^ gamma   above,
///
/// odd about 0 and extended above 1.
struct Transfer {
    double gamma = 1;
    double offset = 0;
    double divisor = 1;
    double slope = 1;
    double knee = 0;  ///< of the encoded component

    bool operator==(const Transfer&) const = default;

    static const Transfer linear;
    static const Transfer sRGB;    ///< IEC 61966-2-1
    static const Transfer rec709;  ///< of cameras: BT.709 and BT.2020, with the digits of H.273
    static const Transfer romm;    ///< ISO 22028-2 (ProPhoto)
    static constexpr Transfer power(double gamma) { return {gamma}; }
};

inline constexpr Transfer Transfer::linear = {};
inline constexpr Transfer Transfer::sRGB = {2.4, 0.055, 1.055, 12.92, 0.04045};
inline constexpr Transfer Transfer::rec709 = {1 / 0.45, 0.09929682680944, 1.09929682680944, 4.5,
                                              4.5 * 0.018053968510807};
inline constexpr Transfer Transfer::romm = {1.8, 0, 1, 16, 1.0 / 32};

/// Of an encoded component.
SPECBAKE_API double linearFrom(double encoded, const Transfer& transfer);

/// sRGB's decoding curve.
SPECBAKE_API double linearFromSRGB(double encoded);
/// Its inverse.
SPECBAKE_API double sRGBFromLinear(double linear);

/// "linear", "srgb", "rec709", "romm", or "gamma:2.2"; for a curve that is none of these its five
/// numbers, "curve:2.4,0.055,1.055,12.92,0.04045".
SPECBAKE_API std::string transferName(const Transfer& transfer);

/// The curve of such a name, in any case; "prophoto" and "gamma2.2" are understood too. Nothing
/// for another text, and for numbers that make no rising curve.
SPECBAKE_API std::optional<Transfer> transferFromName(std::string_view name);

}  // namespace specbake
