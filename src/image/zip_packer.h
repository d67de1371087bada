#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace specbake {

/// OpenEXR's ZIP: the bytes of the samples split into even and odd ones, each replaced by its
/// difference to the one before (plus 128), in a zlib container; or the samples as they are where
/// that does not make them shorter.
///
/// level 1 to 3: ISA-L's deflate, 4 to 12: libdeflate's.
std::vector<std::byte> packZip(std::span<const std::byte> samples, int level);

}  // namespace specbake
