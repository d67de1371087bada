#pragma once

#include "methods/frame.h"

#include <specbake/core/solid.h>

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::bench {

struct ColorSet {
    std::string name;
    std::vector<XYZ> colors;
    double neighbour = 1e-4;  ///< distance in RGB at which continuity is of interest
};

/// Sets of colours under a frame's observer, seeded: the same every time. `count` colours each of
/// the first two (a set that has fewer is taken whole), a tenth of that of the others: there some
/// methods take a hundred times as long.
///
/// - "RGB cube": uniform in the frame's unit cube
/// - "8-bit lattice": sRGB-encoded values 0, 5, …, 255, decoded
/// - "dark": RGB uniform up to 0.05
/// - "near black, saturated": one or two components up to 1e-4, the others 0
/// - "near white": RGB uniform in [0.99, 1]
std::vector<ColorSet> rgbSets(const Frame& frame, std::size_t count);

/// Sets that only the object-colour solid (of the frame's observer) defines, likewise.
///
/// - "solid": uniform in XYZ, by rejection from the box about the solid; at least 20,000
/// - "gauge R": at that gauge (solid.h), on rays towards seeded directions
/// - "Rec.2020 cube", "ACEScg cube": uniform in the cube with these primaries and the frame's
///   white, of those colours that the solid holds
/// - "just outside": a tenth as many, gauge uniform in [1, 1.05]. No spectrum has them: failing is
///   right there.
std::vector<ColorSet> solidSets(const Frame& frame, const Solid& solid, std::size_t count);

/// Seeded colours at a gauge.
std::vector<XYZ> colorsAtGauge(const Solid& solid, double gauge, std::size_t count);

}  // namespace specbake::bench
