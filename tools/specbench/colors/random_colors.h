#pragma once

#include <specbake/core/color.h>
#include <specbake/core/solid.h>

#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace specbake::bench {

using Generator = std::mt19937_64;

/// A double in [low, high) from the 53 high bits: std::uniform_real_distribution may differ
/// between libraries.
double uniform(Generator& random, double low, double high);

/// Three of them, red first.
RGB uniformRGB(Generator& random, double low, double high);

/// The point of the box about the solid at these shares of its sides.
XYZ inBox(const Solid& solid, const RGB& share);

/// The first `count` of the colours drawn that the solid holds.
std::vector<XYZ> firstInSolid(const Solid& solid, std::size_t count,
                              const std::function<XYZ()>& draw);

}  // namespace specbake::bench
