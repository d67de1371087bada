#pragma once

#include "methods/method.h"
#include "texture.h"

namespace specbake::bench {

inline constexpr int kHalfBits = 10;  ///< stored bits of a half's mantissa
inline constexpr int kFewestBits = 4;

/// The reflectances as halves with a mantissa of so many bits, rounded to nearest even.
/// kFewestBits <= bits <= kHalfBits.
Spectrum roundedToBits(const Spectrum& s, int bits);

/// Bytes of the pixels of the texture's spectral image, half, ZIP at its default level, with the
/// mantissas of all channels rounded to so many bits. Nothing is written. Throws FileError.
double packedBytes(const Texture& texture, const Method& method, int bits);

}  // namespace specbake::bench
