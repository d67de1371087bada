#pragma once

#include "mip/box_filter.h"

#include <specbake/image/chunk_grid.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace specbake::internal {

/// A row of tiles of one level, whole.
struct TileRow {
    int level = 0;
    int row = 0;  ///< of tiles
    std::vector<std::shared_ptr<const TexelRow>> texels;
};

/// The levels of an image, each made of the rows of the one before as these arrive from the top.
/// Nothing is held but, of each level, a row of tiles and the rows that the next one waits for.
class Pyramid {
  public:
    /// The first of `levels` is the one whose rows are given.
    Pyramid(std::span<const ChunkGrid> levels, bool alpha);

    /// The next row of the first level.
    void add(TexelRow row) { add(0, std::move(row)); }

    /// The rows of tiles that are complete since the last call, in the order in which they were.
    std::vector<TileRow> takeComplete() { return std::exchange(complete_, {}); }

  private:
    struct Level {
        ChunkGrid grid;
        int arrived = 0;  ///< rows
        std::vector<std::shared_ptr<const TexelRow>> tileRow;
        std::vector<std::shared_ptr<const TexelRow>> waiting;  ///< for the level below
    };

    void add(std::size_t level, TexelRow row);
    void addBelow(std::size_t level);

    std::vector<Level> levels_;
    bool alpha_;
    std::vector<TileRow> complete_;
};

}  // namespace specbake::internal
