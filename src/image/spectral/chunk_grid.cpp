#include <specbake/core/error.h>
#include <specbake/image/chunk_grid.h>

#include <algorithm>
#include <limits>
#include <string>

namespace specbake {
namespace {

void check(const TileSize& tile) {
    const auto [least, largest] = std::minmax(tile.width, tile.height);
    if (least < 1 || largest > TileSize::kLargestSide) {
        throw ArgumentError("a tile's sides go from 1 to " +
                            std::to_string(TileSize::kLargestSide));
    }
}

/// Adds a level of that size. The format numbers chunks by 32 bits.
void addLevel(std::vector<ChunkGrid>& grids, int width, int height, const TileSize& tile) {
    ChunkGrid grid{int(grids.size()), 0, width, height, tile.width, tile.height};
    if (!grids.empty()) grid.firstChunk = grids.back().firstChunk + grids.back().count();
    const long long end = grid.firstChunk + 1LL * grid.across() * grid.down();
    if (end > std::numeric_limits<int>::max()) {
        throw ArgumentError("more tiles than a file can have; larger ones are needed");
    }
    grids.push_back(grid);
}

}  // namespace

Window ChunkGrid::texels(int chunk) const {
    const int x = column(chunk) * chunkWidth;
    const int y = row(chunk) * chunkHeight;
    return {x, y, std::min(chunkWidth, width - x), std::min(chunkHeight, height - y)};
}

std::vector<ChunkGrid> chunkGrids(int width, int height, const StorageOptions& storage) {
    if (!storage.isTiled()) {
        return {{0, 0, width, height, width, rowsPerChunk(storage.compression)}};
    }
    const TileSize tile = storage.tile.value_or(TileSize());
    check(tile);
    std::vector<ChunkGrid> grids;
    addLevel(grids, width, height, tile);
    while (storage.mipmap && (width > 1 || height > 1)) {
        width = halvedSide(width);
        height = halvedSide(height);
        addLevel(grids, width, height, tile);
    }
    return grids;
}

}  // namespace specbake
