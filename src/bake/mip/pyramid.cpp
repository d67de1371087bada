#include "mip/pyramid.h"

#include <algorithm>

namespace specbake::internal {

Pyramid::Pyramid(std::span<const ChunkGrid> levels, bool alpha) : alpha_(alpha) {
    for (const ChunkGrid& grid : levels) levels_.push_back({grid, 0, {}, {}});
}

void Pyramid::add(std::size_t level, TexelRow row) {
    Level& l = levels_[level];
    l.tileRow.push_back(std::make_shared<const TexelRow>(std::move(row)));
    l.waiting.push_back(l.tileRow.back());
    ++l.arrived;
    if (int(l.tileRow.size()) == l.grid.chunkHeight || l.arrived == l.grid.height) {
        const int tileRow = (l.arrived - 1) / l.grid.chunkHeight;
        complete_.push_back({l.grid.level, tileRow, std::exchange(l.tileRow, {})});
    }
    if (level + 1 < levels_.size()) {
        addBelow(level);
    } else {
        l.waiting.clear();
    }
}

/// The next row of the level below, if what it is made of is there: from its first tap on,
/// `waiting`.
void Pyramid::addBelow(std::size_t level) {
    Level& l = levels_[level];
    const int next = levels_[level + 1].arrived;
    const BoxTaps taps = boxTaps(l.grid.height, next);
    if (l.arrived < taps.first + taps.count) return;
    std::vector<const TexelRow*> rows;
    for (const auto& row : l.waiting) rows.push_back(row.get());
    TexelRow below = averageRows(rows, taps, l.grid.width, alpha_);
    const int dropped = boxTaps(l.grid.height, next + 1).first - taps.first;
    l.waiting.erase(l.waiting.begin(), l.waiting.begin() + std::min(dropped, taps.count));
    add(level + 1, std::move(below));
}

}  // namespace specbake::internal
