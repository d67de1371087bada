#pragma once

#include "deflate/row_deflate.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace specbake::internal {

/// A set of a block's bytes, a bit each.
struct ByteSet {
    static constexpr std::size_t kWordBits = 64;

    /// The bits of kWordBits bytes from byte `i` of the block on.
    std::uint64_t from(std::size_t i) const {
        const std::size_t shift = i % kWordBits;
        const std::uint64_t* const w = words.data() + i / kWordBits;
        return w[0] >> shift | w[1] << 1 << (kWordBits - 1 - shift);
    }

    /// The last two words stay empty, so that from() may look beyond the block.
    std::array<std::uint64_t, kDeflateBlock / kWordBits + 2> words{};
};

/// Some literals, then a match (length 0 at the end of a block).
struct Step {
    std::uint32_t literals;
    std::uint16_t length;
    std::uint16_t distance;  ///< its index
};

/// Bytes as literals and matches, block by block. Matches look back 1 byte, or 1 to `rowsBack`
/// rows.
class RowMatcher {
  public:
    static constexpr std::size_t kMostDistances = 4;
    /// For each distance, the bytes that equal the one so far before them.
    using EqualSets = std::array<ByteSet, kMostDistances>;

    /// `bytes` must outlive the matcher; rowsBack < kMostDistances.
    RowMatcher(std::span<const std::uint8_t> bytes, std::size_t rowLength, std::size_t rowsBack);

    const std::vector<std::size_t>& distances() const { return distances_; }

    /// The block from byte `begin` to `end`, kDeflateBlock bytes at most, without matches of fewer
    /// than `shortest` bytes (1 to ByteSet::kWordBits).
    void split(std::size_t begin, std::size_t end, std::size_t shortest, std::vector<Step>& steps);

  private:
    std::span<const std::uint8_t> bytes_;
    std::vector<std::size_t> distances_;
    EqualSets equal_;  ///< of the block at hand; empty beyond the distances there are
};

}  // namespace specbake::internal
