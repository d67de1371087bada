#pragma once

#include <specbake/bake/bake.h>

#include <cstddef>
#include <span>

namespace specbake::internal {

/// Stores floats as halves (two bytes each) with `bits` bits of mantissa, in one rounding, to
/// nearest, ties to even; the bits below are 0, which is what makes a file compress. 0, 1 and the
/// powers of 2 stay; values in [0, 1] stay there. Values are from 0 to 32768. 1 <= bits <= 10.
void storeRounded(std::span<const float> values, int bits, std::byte* halves);

}  // namespace specbake::internal
