#pragma once

#include <cstddef>
#include <span>

namespace specbake {

inline constexpr int kHalfMantissaBits = 10;
inline constexpr int kFewestMantissaBits = 4;

/// Rounds halves (two bytes each) to `bits` bits of mantissa, to nearest, ties to even; the bits
/// below become 0, which is what makes a file compress. 0, 1 and the powers of 2 stay; values in
/// [0, 1] stay there. Finite halves only. 1 <= bits <= 10.
void roundMantissa(std::span<std::byte> halves, int bits);

}  // namespace specbake
