#pragma once

#include "exr_context.h"

#include <cstddef>
#include <span>
#include <vector>

namespace specbake {

/// OpenEXR's PIZ (wavelet and Huffman), by OpenEXRCore's own encoder, for the chunk that begins at
/// row `y` of the data window's coordinates. Safe from several threads on one context.
std::vector<std::byte> packPiz(const ExrContext& context, int y,
                               std::span<const std::byte> samples);

}  // namespace specbake
