#include "demand/level_blocks.h"

#include "refusal.h"

#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace specbake::internal {
namespace {

Window common(const Window& a, const Window& b) {
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x,
            std::min(a.y + a.height, b.y + b.height) - y};
}

}  // namespace

LevelBlocks::LevelBlocks(StoredRows& rows, const TextureInfo& info, const TexelDecoder& decoder,
                         const Spectra& spectra, const std::vector<ChunkGrid>& levels,
                         std::size_t bytes)
    : rows_(rows),
      info_(info),
      decoder_(decoder),
      spectra_(spectra),
      levels_(levels),
      cache_(bytes) {}

Block LevelBlocks::texels(int level, const Window& at, const BlockChannels& channels) {
    return level == 0 ? sampled(at, channels) : assembled(level, at, channels);
}

Block LevelBlocks::sampled(const Window& at, const BlockChannels& channels) {
    Block block(at, channels.count());
    for (int y = 0; y < at.height; ++y) {
        const Window row{at.x, at.y + y, at.width, 1};
        const auto band = rows_.bandOf(row.y);
        sampleRow(row, rows_.rowIn(*band, row.y), channels, block.rows[std::size_t(y)]);
    }
    return block;
}

/// `at`: a row of texels, of the texture's row that `stored` is.
void LevelBlocks::sampleRow(const Window& at, std::span<const std::byte> stored,
                            const BlockChannels& channels, TexelRow& row) {
    std::vector<Upsampler::Color>& colors = colors_.local();
    const auto count = std::size_t(at.width);
    const std::size_t texel = stored.size() / std::size_t(info_.data.width);
    colors.resize(count);
    decoder_.decode(stored.subspan(texel * std::size_t(at.x), texel * count), count, colors.data(),
                    channels.alpha ? row.data() : nullptr);
    if (channels.samples.empty()) return;
    float* planes = row.data() + (channels.alpha ? count : 0);
    ColorCensus census;
    census.add(spectra_.sample(colors, channels.samples, planes),
               std::size_t(at.y) * std::size_t(info_.data.width) + std::size_t(at.x));
    refuseIncomplete(info_, census);
}

Block LevelBlocks::averaged(int level, const Window& at, const BlockChannels& channels) {
    const ChunkGrid& above = levels_[std::size_t(level) - 1];
    const Stretch across = sourceStretch(above.width, {at.x, at.width});
    const Stretch down = sourceStretch(above.height, {at.y, at.height});
    const Block source =
        texels(level - 1, {across.first, down.first, across.count, down.count}, channels);
    Block block(at, 0);
    for (int y = 0; y < at.height; ++y) {
        const BoxTaps taps = boxTaps(above.height, at.y + y);
        std::vector<const TexelRow*> rows;
        for (int k = 0; k < taps.count; ++k) {
            rows.push_back(&source.rows[std::size_t(taps.first + k - down.first)]);
        }
        block.rows[std::size_t(y)] =
            averageRows(rows, taps, above.width, channels.alpha, {at.x, at.width});
    }
    return block;
}

/// Of kept blocks, and of those that are made now.
Block LevelBlocks::assembled(int level, const Window& at, const BlockChannels& channels) {
    const ChunkGrid& grid = levels_[std::size_t(level)];
    const Window whole{0, 0, grid.width, grid.height};
    std::vector<Window> cells;
    for (int y = at.y / kSide * kSide; y < at.y + at.height; y += kSide) {
        for (int x = at.x / kSide * kSide; x < at.x + at.width; x += kSide) {
            cells.push_back(common({x, y, kSide, kSide}, whole));
        }
    }
    Block block(at, channels.count());
    // Apart from other work, of which a waiting thread would take up more and more, and its memory.
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for_each(cells,
                               [&](const Window& cell) { addPart(block, level, cell, channels); });
    });
    return block;
}

/// Of a block that is not kept and of which less than half a side is wanted (the edge that an
/// average over three texels takes of its neighbour), only that is made.
void LevelBlocks::addPart(Block& whole, int level, const Window& cell,
                          const BlockChannels& channels) {
    const Window part = common(cell, whole.at);
    const BlockCache::Key key{level, cell.x, cell.y, channels.samples};
    auto block = cache_.find(key);
    if (!block && (2 * part.width < cell.width || 2 * part.height < cell.height)) {
        whole.copy(averaged(level, part, channels), part, channels.count());
        return;
    }
    if (!block) {
        block = std::make_shared<const Block>(averaged(level, cell, channels));
        cache_.store(key, block);
    }
    whole.copy(*block, part, channels.count());
}

}  // namespace specbake::internal
