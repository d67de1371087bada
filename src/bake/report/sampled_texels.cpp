#include "report/sampled_texels.h"

#include <algorithm>
#include <cmath>

namespace specbake::internal {

Blocks::Blocks(int imageWidth, int imageHeight, int side)
    : step((std::max(imageWidth, imageHeight) - 1) / side + 1),
      width(imageWidth),
      height(imageHeight),
      columns((imageWidth - 1) / step + 1),
      rows((imageHeight - 1) / step + 1) {}

int Blocks::middle(int index, int length) const {
    return std::min(index * step + step / 2, length - 1);
}

void DifferenceHistogram::add(double difference) {
    const double place = (std::log10(std::max(difference, 1e-30)) - kFrom) * kPerDecade;
    ++counts[std::size_t(std::clamp(std::floor(place), 0.0, double(counts.size() - 1)))];
}

SampledTexels::SampledTexels(const Blocks& imageBlocks, std::size_t bandsOfTexel)
    : blocks(imageBlocks),
      bandCount(bandsOfTexel),
      bands(imageBlocks.count() * bandsOfTexel),
      differences(imageBlocks.count()),
      marks(imageBlocks.count()) {}

void SampledTexels::take(const ComparedRows& rows) {
    for (int row = 0; row < rows.count; ++row) {
        const int y = rows.first + row;
        const int blockRow = y / blocks.step;
        const std::size_t first = std::size_t(row) * std::size_t(blocks.width);
        for (int x = 0; x < blocks.width; ++x) {
            const std::size_t block =
                std::size_t(blockRow) * std::size_t(blocks.columns) + std::size_t(x / blocks.step);
            mark(block, rows.texels[first + std::size_t(x)]);
        }
        if (y != blocks.middle(blockRow, blocks.height)) continue;
        for (int column = 0; column < blocks.columns; ++column) {
            const std::size_t block =
                std::size_t(blockRow) * std::size_t(blocks.columns) + std::size_t(column);
            const std::size_t texel = first + std::size_t(blocks.middle(column, blocks.width));
            std::copy_n(&rows.bands[texel * bandCount], bandCount, &bands[block * bandCount]);
        }
    }
}

void SampledTexels::mark(std::size_t block, const TexelDifference& found) {
    if (!found.finite) {
        marks[block] |= kNotFinite;
        return;
    }
    if (found.outside) marks[block] |= kOutside;
    differences[block] = std::max(differences[block], float(found.de2000));
    histogram.add(found.de2000);
}

}  // namespace specbake::internal
