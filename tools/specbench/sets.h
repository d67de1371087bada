#pragma once

#include "methods/frame.h"

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::bench {

struct ColorSet {
    std::string name;
    std::vector<XYZ> colors;
};

/// Sets of colours under a frame's observer, seeded: the same every time. `count` colours each;
/// a set that has fewer is taken whole.
///
/// - "RGB cube": uniform in the frame's unit cube
/// - "8-bit lattice": sRGB-encoded values 0, 5, …, 255, decoded
/// - "dark": RGB uniform up to 0.05
/// - "near black, saturated": one or two components up to 1e-4, the others 0
/// - "near white": RGB uniform in [0.99, 1]
std::vector<ColorSet> rgbSets(const Frame& frame, std::size_t count);

}  // namespace specbake::bench
