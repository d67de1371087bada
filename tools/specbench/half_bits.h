#pragma once

#include <specbake/core/spectrum.h>

#include <cstdint>

namespace specbake::bench {

inline constexpr int kHalfBits = 10;  ///< stored bits of a half's mantissa

/// The bit pattern of the half nearest to a value, its mantissa rounded to so many bits, ties to
/// even. 1 <= bits <= kHalfBits; finite values.
std::uint16_t halfPattern(double value, int bits);

/// What a spectrum becomes when it is stored so.
Spectrum roundedToBits(const Spectrum& s, int bits);

}  // namespace specbake::bench
