#pragma once

#include "exr_context.h"

#include <cstddef>
#include <span>
#include <vector>

namespace specbake {

/// OpenEXR's PIZ (wavelet and Huffman), by OpenEXRCore's own encoder, for one chunk of a level.
/// Safe from several threads on one context.
std::vector<std::byte> packPiz(const ExrContext& context, const ChunkGrid& level, int chunk,
                               std::span<const std::byte> samples);

}  // namespace specbake
