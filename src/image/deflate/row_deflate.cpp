// Compiled once for each instruction set by foreach_target.h; rowDeflate() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "deflate/row_deflate.cpp"
#include "deflate/row_deflate.h"

#include "deflate/bit_writer.h"
#include "deflate/code_lengths.h"
#include "deflate/deflate_symbols.h"
#include "deflate/huffman.h"
#include "deflate/row_matcher.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

constexpr std::size_t kBlock = kDeflateBlock;
/// Bits of a word. Deflate allows 15, but then only 3 words fit between two flushes.
constexpr std::uint32_t kLongestWord = 14;
/// A match must have at least this many bytes, however many bits a literal takes, ...
constexpr std::size_t kFewestAsked = 5;
/// ... and never needs more than this many, however few it takes.
constexpr std::size_t kMostAsked = 32;

/// How often what occurs in a block.
struct Counts {
    Counts(const std::uint8_t* bytes, std::span<const Step> steps) {
        for (const Step& step : steps) {
            std::size_t left = step.literals;
            for (; left >= 4; left -= 4, bytes += 4) {
                for (std::size_t i = 0; i < 4; ++i) ++ofFour[i][bytes[i]];
            }
            for (; left > 0; --left) ++ofFour[0][*bytes++];
            ++lengths[step.length];
            ++distances[step.distance];
            bytes += step.length;
        }
        --distances[0];  // of the last step, which has no match
    }

    std::array<std::uint32_t, 256> literals() const {
        std::array<std::uint32_t, 256> sum{};
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] = ofFour[0][i] + ofFour[1][i] + ofFour[2][i] + ofFour[3][i];
        }
        return sum;
    }

    /// Four counts of each literal: adding to the one that was just added to would have to wait.
    std::array<std::array<std::uint32_t, 256>, 4> ofFour{};
    std::array<std::uint32_t, kLongestMatch + 1> lengths{};
    std::array<std::uint32_t, RowMatcher::kMostDistances> distances{};
};

/// The words of one block: literals and, extra bits included, lengths and distances.
class BlockCode {
  public:
    BlockCode(const std::uint8_t* bytes, std::span<const Step> steps,
              const std::vector<std::size_t>& distances) {
        const Counts counts(bytes, steps);
        const std::array<std::uint32_t, 256> literals = counts.literals();
        std::array<std::uint32_t, kLiteralCodes> literalCounts{};
        std::copy(literals.begin(), literals.end(), literalCounts.begin());
        std::array<std::uint32_t, kDistanceCodes> distanceCounts{};
        for (std::size_t i = kShortestMatch; i <= kLongestMatch; ++i) {
            literalCounts[lengthSymbol(i).symbol] += counts.lengths[i];
        }
        for (std::size_t d = 0; d < distances.size(); ++d) {
            distanceCounts[distanceSymbol(distances[d]).symbol] += counts.distances[d];
        }
        ++literalCounts[kEndOfBlock];
        literals_ = huffmanCode(literalCounts, kLongestWord);
        distances_ = huffmanCode(distanceCounts, kLongestWord);
        for (std::size_t i = kShortestMatch; i <= kLongestMatch; ++i) {
            lengthWords_[i] = withExtra(literals_, lengthSymbol(i));
        }
        for (const std::size_t distance : distances) {
            distanceWords_.push_back(withExtra(distances_, distanceSymbol(distance)));
        }
        shortestWorthwhile_ = shortestWorthwhile(literals);
    }

    /// The fewest bytes of a match that spares bits, if its bytes cost what literals do here.
    std::size_t shortestWorthwhile() const { return shortestWorthwhile_; }

    void write(const std::uint8_t* bytes, std::span<const Step> steps, BitWriter& file) const {
        writeCodeLengths(literals_, distances_, file);
        BitWriter out = file;  // in registers
        const CodeWord* const words = literals_.data();
        for (const Step& step : steps) {
            std::size_t left = step.literals;
            for (; left >= 4; left -= 4, bytes += 4) {
                static_assert(4 * kLongestWord <= BitWriter::kMostBits);
                for (std::size_t i = 0; i < 4; ++i) out.put(words[bytes[i]]);
                out.flush();
            }
            for (; left > 0; --left) out.put(words[*bytes++]);
            out.flush();
            if (step.length == 0) continue;
            out.put(lengthWords_[step.length]);
            out.put(distanceWords_[step.distance]);
            out.flush();
            bytes += step.length;
        }
        out.put(literals_[kEndOfBlock]);
        out.flush();
        file = out;
    }

  private:
    std::size_t shortestWorthwhile(const std::array<std::uint32_t, 256>& counts) const {
        /// Bits of a match: of its words, and of what rarer literals cost those that are left.
        /// Measured: files are smallest between 20 and 26.
        constexpr std::uint64_t matchBits = 24;
        std::uint64_t literals = 0;
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            literals += counts[i];
            bits += std::uint64_t(counts[i]) * literals_[i].length;
        }
        const std::uint64_t shortest = matchBits * literals / std::max<std::uint64_t>(bits, 1);
        return std::clamp<std::size_t>(shortest, kFewestAsked, kMostAsked);
    }

    static CodeWord withExtra(const std::vector<CodeWord>& code, const Symbol& s) {
        const CodeWord& word = code[s.symbol];
        return {word.bits | s.extra << word.length, word.length + s.extraBits};
    }

    std::vector<CodeWord> literals_, distances_;
    std::array<CodeWord, kLongestMatch + 1> lengthWords_;
    std::vector<CodeWord> distanceWords_;
    std::size_t shortestWorthwhile_;
};

void putChecksum(std::span<const std::uint8_t> bytes, std::uint8_t* to) {
    const std::uint32_t sum = libdeflate_adler32(1, bytes.data(), bytes.size());
    for (std::size_t i = 0; i < 4; ++i) to[i] = std::uint8_t(sum >> (24 - 8 * i));
}

std::size_t deflateRows(std::span<const std::uint8_t> bytes, std::size_t rowLength,
                        std::size_t rowsBack, std::span<std::uint8_t> packed) {
    const auto matcher = std::make_unique<RowMatcher>(bytes, rowLength, rowsBack);
    std::vector<Step> steps;
    std::size_t shortest = kFewestAsked;
    packed[0] = 0x78;  // deflate with a window of 32768 bytes
    packed[1] = 0x5E;  // a fast encoder; with the byte before a multiple of 31
    BitWriter out(packed.data() + 2);
    for (std::size_t begin = 0; begin < bytes.size(); begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, bytes.size());
        if (std::size_t(out.position() - packed.data()) > bytes.size()) return 0;
        matcher->split(begin, end, shortest, steps);
        const std::uint8_t* const block = bytes.data() + begin;
        out.put(end == bytes.size() ? 1 : 0, 1);
        out.put(2, 2);  // codes of its own
        const BlockCode code(block, steps, matcher->distances());
        code.write(block, steps, out);
        shortest = code.shortestWorthwhile();
    }
    out.finish();
    putChecksum(bytes, out.position());
    const auto size = std::size_t(out.position() - packed.data()) + 4;
    return size <= bytes.size() ? size : 0;
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(deflateRows);
}  // namespace

std::size_t rowDeflate(std::span<const std::uint8_t> bytes, std::size_t rowLength,
                       std::size_t rowsBack, std::span<std::uint8_t> packed) {
    return HWY_DYNAMIC_DISPATCH(deflateRows)(bytes, rowLength, rowsBack, packed);
}

}  // namespace specbake::internal
#endif
