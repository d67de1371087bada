#pragma once

#include <specbake/bake/bake.h>

#include <cstddef>
#include <span>

namespace specbake::internal {

/// Rounds halves (two bytes each) to `bits` bits of mantissa, to nearest, ties to even; the bits
/// below become 0, which is what makes a file compress. 0, 1 and the powers of 2 stay; values in
/// [0, 1] stay there. Finite halves only. 1 <= bits <= 10.
void roundMantissa(std::span<std::byte> halves, int bits);

}  // namespace specbake::internal
