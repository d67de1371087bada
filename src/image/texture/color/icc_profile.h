#pragma once

#include "texture/color/color_signs.h"

#include <specbake/image/color_meaning.h>

#include <stdexcept>

namespace specbake::internal {

/// Why a profile cannot be used: one line.
class ProfileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What pixels of so many channels of that kind, not Lab, mean by an ICC profile, by Little CMS:
///
/// - a profile of a matrix and curves becomes primaries, white and curves. It is a known space
///   where it agrees with one to kSameSpace; else a space named "icc";
/// - a profile of grey becomes curves, of lin_rec709: neutral in any case;
/// - any other becomes a transform to lin_prophoto, in floating point and not clipped, by the
///   profile's relative colorimetric table.
///
/// White is the medium's (white paper) and becomes (1, 1, 1). Throws ProfileError for a profile
/// that is damaged, larger than kLargestProfile, or for other colours.
ColorMeaning meaningOfProfile(const std::string& bytes, ColorModel model, int channels);

/// The largest CIEDE2000 between a profile and a known space that are taken for the same.
inline constexpr double kSameSpace = 0.05;

}  // namespace specbake::internal
