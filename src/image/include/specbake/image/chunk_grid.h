#pragma once

#include <specbake/core/api.h>
#include <specbake/image/spectral_layout.h>

#include <vector>

namespace specbake {

/// One level of a file, cut into chunks: runs of whole rows, or tiles. They go from left to right,
/// then from top to bottom; those at the right and lower ends may be smaller.
///
/// Chunks are numbered through the whole file, level by level, as its table of offsets has them.
struct SPECBAKE_API ChunkGrid {
    int level = 0;
    int firstChunk = 0;
    int width = 0, height = 0;  ///< of the level
    int chunkWidth = 0, chunkHeight = 0;

    int across() const { return (width + chunkWidth - 1) / chunkWidth; }
    int down() const { return (height + chunkHeight - 1) / chunkHeight; }
    int count() const { return across() * down(); }
    int column(int chunk) const { return (chunk - firstChunk) % across(); }
    int row(int chunk) const { return (chunk - firstChunk) / across(); }

    /// A chunk's texels, counted from the level's corner.
    Window texels(int chunk) const;
};

/// A side of the level below a level of that side: half of it, rounded down, but never 0.
constexpr int halvedSide(int side) {
    return side > 1 ? side / 2 : 1;
}

/// The levels of a file of that size, the largest first. Throws ArgumentError for impossible tiles,
/// and for more than a file can have.
SPECBAKE_API std::vector<ChunkGrid> chunkGrids(int width, int height,
                                               const StorageOptions& storage);

}  // namespace specbake
