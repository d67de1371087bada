#pragma once

#include "texel_source.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace specbake::internal {

using TexelColor = std::array<float, 3>;

/// A colour, and how many texels have it.
struct ColorCount {
    TexelColor color{};
    std::size_t texels = 0;
};

/// Reads a texture through and hands over its linear colours: every colour that occurs at least
/// once, most of them not often, with the texels for which it stands this time. Colours that are
/// not finite are left out. `visit` is called by several threads at once. Throws what the reader
/// throws, and Cancelled.
void surveyColors(const TexelSource& source,
                  const std::function<void(std::span<const ColorCount>)>& visit);

/// The different colours of a texture, each with all its texels: every one where there are no more
/// than `most`, else those of the smallest hashes of their bits, a fair sample, the same in every
/// run.
struct ColorTally {
    std::vector<ColorCount> colors;
    bool all = true;
};
ColorTally tallyColors(const TexelSource& source, std::size_t most);

}  // namespace specbake::internal
