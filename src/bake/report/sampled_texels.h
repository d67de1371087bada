#pragma once

#include "verify/observed.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace specbake::internal {

/// An image in equal blocks, each shown by one texel.
struct Blocks {
    int step = 1;  ///< texels along the side of a block
    int width = 0, height = 0;
    int columns = 0, rows = 0;

    /// No more than `side` blocks along the longer side.
    Blocks(int width, int height, int side);
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    /// The place of the texel that stands for block `index` of a row or a column.
    int middle(int index, int length) const;
};

/// How often differences of a size occur: bin k counts those from 10^(from + k/perDecade) on, the
/// first also smaller ones and the last also larger ones.
struct DifferenceHistogram {
    static constexpr int kFrom = -6;
    static constexpr int kPerDecade = 4;
    std::array<std::size_t, std::size_t(8) * kPerDecade> counts{};

    void add(double difference);
};

/// What a report keeps of the rows that verify() compares.
class SampledTexels {
  public:
    /// `bandsOfTexel`: how many.
    SampledTexels(const Blocks& blocks, std::size_t bandsOfTexel);

    /// Rows in order.
    void take(const ComparedRows& rows);

    enum Mark : std::uint8_t { kOutside = 1, kNotFinite = 2 };

    Blocks blocks;
    std::size_t bandCount;            ///< of a texel
    std::vector<float> bands;         ///< of the texels that stand for the blocks
    std::vector<float> differences;   ///< the largest CIEDE2000 in each block
    std::vector<std::uint8_t> marks;  ///< what any texel of the block is
    DifferenceHistogram histogram;    ///< of all texels

  private:
    void mark(std::size_t block, const TexelDifference& found);
};

}  // namespace specbake::internal
