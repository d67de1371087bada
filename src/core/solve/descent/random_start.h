#pragma once

#include <specbake/core/color.h>
#include <specbake/core/spectrum.h>

namespace specbake::internal {

/// A point of the box, uniform in it, that depends on the colour's bits and the start's number
/// alone: the same with every standard library, and whatever was solved before.
Spectrum randomStart(const XYZ& color, int number);

}  // namespace specbake::internal
