#pragma once

#include "mip/box_filter.h"

#include <specbake/core/sampling.h>
#include <specbake/image/image_types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace specbake::internal {

/// The channels of unrounded texels: alpha first if there is any, then samples of spectra.
struct BlockChannels {
    bool alpha = false;
    std::vector<std::size_t> samples;  ///< numbers in SampleSelection::channels()
    std::size_t count() const { return samples.size() + (alpha ? 1 : 0); }
};

/// A rectangle of unrounded texels of one level, row by row, each as averageRows() has them.
struct Block {
    Window at;  ///< counted from the level's corner
    std::vector<TexelRow> rows;

    Block(const Window& window, std::size_t channels)
        : at(window),
          rows(std::size_t(window.height), TexelRow(std::size_t(window.width) * channels)) {}

    std::size_t bytes() const {
        return rows.empty() ? 0 : rows.size() * rows.front().size() * sizeof(float);
    }

    /// Takes over the texels that lie in `part` from a block that holds them.
    void copy(const Block& from, const Window& part, std::size_t channels) {
        for (int y = part.y; y < part.y + part.height; ++y) {
            const TexelRow& source = from.rows[std::size_t(y - from.at.y)];
            TexelRow& target = rows[std::size_t(y - at.y)];
            for (std::size_t c = 0; c < channels; ++c) {
                const std::size_t first = c * std::size_t(from.at.width);
                const auto begin = source.begin() + std::ptrdiff_t(first) + (part.x - from.at.x);
                std::copy_n(
                    begin, part.width,
                    target.begin() + std::ptrdiff_t(c * std::size_t(at.width)) + (part.x - at.x));
            }
        }
    }
};

}  // namespace specbake::internal
