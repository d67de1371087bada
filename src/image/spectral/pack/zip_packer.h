#pragma once

#include <cstddef>
#include <vector>

namespace specbake::internal {

/// OpenEXR's ZIP: the bytes of the samples split into even and odd ones, each replaced by its
/// difference to the one before (plus 128), in a zlib container; or the samples as they are where
/// that does not make them shorter. In the samples' place: the memory serves both. The same bytes
/// on every processor.
///
/// `rowBytes`: of one channel's row, even. level 1 to 3: rowDeflate() looking back as many rows
/// (row_deflate.h), where they fit its window; 4 to 12, and 1 beyond the window: libdeflate's.
void packZip(std::vector<std::byte>& samples, std::size_t rowBytes, int level);

}  // namespace specbake::internal
