#include <specbake/core/error.h>
#include <specbake/image/chunk_grid.h>

#include <algorithm>
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
    std::vector<ChunkGrid> grids = {{0, 0, width, height, tile.width, tile.height}};
    while (storage.mipmap && (grids.back().width > 1 || grids.back().height > 1)) {
        const ChunkGrid& above = grids.back();
        grids.push_back({above.level + 1, above.firstChunk + above.count(), halvedSide(above.width),
                         halvedSide(above.height), tile.width, tile.height});
    }
    return grids;
}

}  // namespace specbake
