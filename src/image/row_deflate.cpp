// Compiled once for each instruction set by foreach_target.h; rowDeflate() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "row_deflate.cpp"
#include "row_deflate.h"

#include "bit_writer.h"
#include "code_lengths.h"
#include "deflate_symbols.h"
#include "huffman.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace specbake::HWY_NAMESPACE {
namespace {

constexpr std::size_t kBlock = kDeflateBlock;
constexpr std::size_t kShortest = 5;  ///< shorter matches cost about what they spare
/// Bits of a word. Deflate allows 15, but then only 3 words fit between two flushes.
constexpr std::uint32_t kLongestWord = 14;
constexpr std::size_t kMostDistances = 8;  ///< a bit each of a byte

/// Some literals, then a match (length 0 at the end of a block).
struct Step {
    std::uint32_t literals;
    std::uint16_t length;
    std::uint16_t distance;  ///< its index
};

template <class Word>
Word load(const std::uint8_t* at) {
    Word word;
    std::memcpy(&word, at, sizeof word);
    return word;
}

/// The place in memory of the first byte that is not 0.
std::size_t firstByteSet(std::uint64_t bytes) {
    const bool little = std::endian::native == std::endian::little;
    return std::size_t(little ? std::countr_zero(bytes) : std::countl_zero(bytes)) / 8;
}

/// How many bytes from `a` on equal those from `b` on, `most` at most.
std::size_t equalBytes(const std::uint8_t* a, const std::uint8_t* b, std::size_t most) {
    std::size_t n = 0;
    for (; n + 8 <= most; n += 8) {
        const std::uint64_t difference = load<std::uint64_t>(a + n) ^ load<std::uint64_t>(b + n);
        if (difference != 0) return n + firstByteSet(difference);
    }
    while (n < most && a[n] == b[n]) ++n;
    return n;
}

/// Bytes as literals and matches, block by block.
class Matcher {
  public:
    Matcher(std::span<const std::uint8_t> bytes, std::vector<std::size_t> distances)
        : bytes_(bytes), distances_(std::move(distances)) {}

    const std::vector<std::size_t>& distances() const { return distances_; }

    void split(std::size_t begin, std::size_t end, std::vector<Step>& steps) {
        steps.clear();
        findStarts(begin, end);
        std::size_t literalsFrom = begin;
        for (std::size_t i = nextStart(0); i < kBlock; i = nextStart(literalsFrom - begin)) {
            Step step = longestAt(begin + i, end, starts_[i]);
            step.literals = std::uint32_t(begin + i - literalsFrom);
            steps.push_back(step);
            literalsFrom = begin + i + step.length;
        }
        steps.push_back({std::uint32_t(end - literalsFrom), 0, 0});
    }

  private:
    /// The distances at which a match begins, one bit each, for each byte of a block.
    void findStarts(std::size_t begin, std::size_t end) {
        starts_.fill(0);
        for (std::size_t d = 0; d < distances_.size(); ++d) {
            const std::size_t distance = distances_[d];
            const std::size_t first = std::max(begin, std::min(distance, end));
            const std::uint8_t* const at = bytes_.data() + first;
            const std::uint8_t* const before = bytes_.data() + (first - std::min(first, distance));
            const std::size_t count = end - first;
            for (std::size_t i = 0; i < count; ++i) {
                equal_[i] = std::uint8_t(at[i] == before[i] ? 1U << d : 0U);
            }
            std::uint8_t* const starts = starts_.data() + (first - begin);
            const std::uint8_t* const e = equal_.data();
            for (std::size_t i = 0; i + kShortest <= count; ++i) {
                starts[i] |= std::uint8_t(e[i] & e[i + 1] & e[i + 2] & e[i + 3] & e[i + 4]);
            }
        }
    }

    /// The first byte from `i` on at which a match begins; kBlock or beyond if there is none.
    std::size_t nextStart(std::size_t i) const {
        for (; i < kBlock; i += 8) {
            const auto eight = load<std::uint64_t>(starts_.data() + i);
            if (eight != 0) return i + firstByteSet(eight);
        }
        return i;
    }

    Step longestAt(std::size_t i, std::size_t end, unsigned which) const {
        const std::uint8_t* const at = bytes_.data() + i;
        const std::size_t most = std::min(end - i, kLongestMatch);
        Step best = {0, 0, 0};
        for (; which != 0; which &= which - 1) {
            const auto d = std::size_t(std::countr_zero(which));
            const std::size_t length = equalBytes(at, at - distances_[d], most);
            if (length > best.length) best = {0, std::uint16_t(length), std::uint16_t(d)};
        }
        return best;
    }

    std::span<const std::uint8_t> bytes_;
    std::vector<std::size_t> distances_;
    std::array<std::uint8_t, kBlock> equal_;
    std::array<std::uint8_t, kBlock + 8> starts_;  ///< none in the last 8
};

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

    std::array<std::uint32_t, kLiteralCodes> literals() const {
        std::array<std::uint32_t, kLiteralCodes> sum{};
        for (std::size_t i = 0; i < 256; ++i) {
            sum[i] = ofFour[0][i] + ofFour[1][i] + ofFour[2][i] + ofFour[3][i];
        }
        return sum;
    }

    /// Four counts of each literal: adding to the one that was just added to would have to wait.
    std::array<std::array<std::uint32_t, 256>, 4> ofFour{};
    std::array<std::uint32_t, kLongestMatch + 1> lengths{};
    std::array<std::uint32_t, kMostDistances> distances{};
};

/// The words of one block: literals and, extra bits included, lengths and distances.
class BlockCode {
  public:
    BlockCode(const std::uint8_t* bytes, std::span<const Step> steps,
              const std::vector<std::size_t>& distances) {
        const Counts counts(bytes, steps);
        std::array<std::uint32_t, kLiteralCodes> literalCounts = counts.literals();
        std::array<std::uint32_t, kDistanceCodes> distanceCounts{};
        for (std::size_t i = kShortest; i <= kLongestMatch; ++i) {
            literalCounts[lengthSymbol(i).symbol] += counts.lengths[i];
        }
        for (std::size_t d = 0; d < distances.size(); ++d) {
            distanceCounts[distanceSymbol(distances[d]).symbol] += counts.distances[d];
        }
        ++literalCounts[kEndOfBlock];
        literals_ = huffmanCode(literalCounts, kLongestWord);
        distances_ = huffmanCode(distanceCounts, kLongestWord);
        for (std::size_t i = kShortest; i <= kLongestMatch; ++i) {
            lengthWords_[i] = withExtra(literals_, lengthSymbol(i));
        }
        for (const std::size_t distance : distances) {
            distanceWords_.push_back(withExtra(distances_, distanceSymbol(distance)));
        }
    }

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
    static CodeWord withExtra(const std::vector<CodeWord>& code, const Symbol& s) {
        const CodeWord& word = code[s.symbol];
        return {word.bits | s.extra << word.length, word.length + s.extraBits};
    }

    std::vector<CodeWord> literals_, distances_;
    std::array<CodeWord, kLongestMatch + 1> lengthWords_;
    std::vector<CodeWord> distanceWords_;
};

void putChecksum(std::span<const std::uint8_t> bytes, std::uint8_t* to) {
    const std::uint32_t sum = libdeflate_adler32(1, bytes.data(), bytes.size());
    for (std::size_t i = 0; i < 4; ++i) to[i] = std::uint8_t(sum >> (24 - 8 * i));
}

std::vector<std::size_t> distancesOf(std::size_t rowLength, std::size_t rowsBack) {
    std::vector<std::size_t> distances = {1};
    for (std::size_t rows = 1; rows <= rowsBack && rows * rowLength <= kDeflateWindow; ++rows) {
        distances.push_back(rows * rowLength);
    }
    return distances;
}

std::size_t deflateRows(std::span<const std::uint8_t> bytes, std::size_t rowLength,
                        std::size_t rowsBack, std::span<std::uint8_t> packed) {
    Matcher matcher(bytes, distancesOf(rowLength, rowsBack));
    std::vector<Step> steps;
    packed[0] = 0x78;  // deflate with a window of 32768 bytes
    packed[1] = 0x5E;  // a fast encoder; with the byte before a multiple of 31
    BitWriter out(packed.data() + 2);
    for (std::size_t begin = 0; begin < bytes.size(); begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, bytes.size());
        if (std::size_t(out.position() - packed.data()) > bytes.size()) return 0;
        matcher.split(begin, end, steps);
        const std::uint8_t* const block = bytes.data() + begin;
        out.put(end == bytes.size() ? 1 : 0, 1);
        out.put(2, 2);  // codes of its own
        BlockCode(block, steps, matcher.distances()).write(block, steps, out);
    }
    out.finish();
    putChecksum(bytes, out.position());
    const auto size = std::size_t(out.position() - packed.data()) + 4;
    return size <= bytes.size() ? size : 0;
}

}  // namespace
}  // namespace specbake::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake {
namespace {
HWY_EXPORT(deflateRows);
}  // namespace

std::size_t rowDeflate(std::span<const std::uint8_t> bytes, std::size_t rowLength,
                       std::size_t rowsBack, std::span<std::uint8_t> packed) {
    return HWY_DYNAMIC_DISPATCH(deflateRows)(bytes, rowLength, rowsBack, packed);
}

}  // namespace specbake
#endif
