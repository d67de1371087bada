#pragma once

#include "texel_source.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace specbake::internal {

using TexelColor = std::array<float, 3>;

/// Reads a texture through and hands over its linear colours: every colour that occurs at least
/// once, most of them not often. Colours that are not finite are left out. `visit` is called by
/// several threads at once. Throws what the reader throws, and Cancelled.
void surveyColors(const TexelSource& source,
                  const std::function<void(std::span<const TexelColor>)>& visit);

/// Up to `most` different colours of a texture, chosen by a hash of their bits: all of them where
/// there are no more, else a fair sample, the same in every run. Sorted.
std::vector<TexelColor> sampleColors(const TexelSource& source, std::size_t most);

}  // namespace specbake::internal
