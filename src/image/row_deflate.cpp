#include "row_deflate.h"

#include "bit_writer.h"
#include "huffman.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace specbake {
namespace {

constexpr std::size_t kBlock = 65536;  ///< bytes that share a Huffman code
constexpr std::size_t kShortest = 5;   ///< shorter matches cost about what they spare
constexpr std::size_t kLongest = 258;
constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kLiteralCodes = 286;
constexpr std::size_t kDistanceCodes = 30;
constexpr std::uint32_t kLongestWord =
    14;  ///< bits; deflate allows 15, but then only 3 fit at once

/// A length or distance as deflate writes it: a symbol, then extra bits (RFC 1951, 3.2.5).
struct Symbol {
    std::uint32_t symbol, extraBits, extra;
};

/// Both scales: beyond the first steps, 2^stepBits symbols to each power of two.
Symbol onScale(std::uint32_t value, std::uint32_t stepBits) {
    const auto bits = std::uint32_t(std::bit_width(value));
    if (bits <= stepBits + 1) return {value, 0, 0};
    const std::uint32_t extraBits = bits - stepBits - 1;
    const std::uint32_t step = value >> extraBits;  // its highest bit is 2^stepBits
    return {(extraBits << stepBits) + step, extraBits, value & ((1U << extraBits) - 1)};
}

Symbol lengthSymbol(std::size_t length) {
    if (length == kLongest) return {285, 0, 0};
    Symbol s = onScale(std::uint32_t(length) - 3, 2);
    s.symbol += 257;
    return s;
}

Symbol distanceSymbol(std::size_t distance) {
    return onScale(std::uint32_t(distance) - 1, 1);
}

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
        const std::size_t most = std::min(end - i, kLongest);
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

/// Code lengths of both codes, one after the other, in the symbols of RFC 1951, 3.2.7.
class LengthsHeader {
  public:
    LengthsHeader(std::span<const CodeWord> literals, std::span<const CodeWord> distances)
        : literals_(used(literals, 257)), distances_(used(distances, 1)) {
        std::vector<std::uint32_t> lengths;
        for (std::size_t i = 0; i < literals_; ++i) lengths.push_back(literals[i].length);
        for (std::size_t i = 0; i < distances_; ++i) lengths.push_back(distances[i].length);
        for (std::size_t i = 0; i < lengths.size();) i += addRun(lengths, i);
    }

    void write(BitWriter& out) const {
        constexpr std::array<std::size_t, 19> order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                       11, 4,  12, 3, 13, 2, 14, 1, 15};
        // Two symbols at least, since decoders refuse a code that is not complete.
        std::array<std::uint32_t, 19> counts{};
        counts[0] = counts[18] = 1;
        for (const Symbol& s : symbols_) ++counts[s.symbol];
        const auto code = huffmanCode(counts, 7);
        out.put(literals_ - 257, 5);
        out.put(distances_ - 1, 5);
        out.put(order.size() - 4, 4);
        out.flush();
        for (const std::size_t s : order) {
            out.put(code[s].length, 3);
            out.flush();
        }
        for (const Symbol& s : symbols_) {
            out.put(code[s.symbol].bits, code[s.symbol].length);
            out.put(s.extra, s.extraBits);
            out.flush();
        }
    }

  private:
    static std::size_t used(std::span<const CodeWord> code, std::size_t least) {
        std::size_t count = code.size();
        while (count > least && code[count - 1].length == 0) --count;
        return count;
    }

    /// Adds a symbol for the lengths from `first` on; returns how many it stands for.
    std::size_t addRun(const std::vector<std::uint32_t>& lengths, std::size_t first) {
        std::size_t run = 1;
        while (first + run < lengths.size() && lengths[first + run] == lengths[first]) ++run;
        const bool zeros = lengths[first] == 0;
        const bool repeats = first > 0 && lengths[first - 1] == lengths[first];
        if (zeros && run >= 11) return add(18, 7, 11, std::min<std::size_t>(run, 138));
        if (zeros && run >= 3) return add(17, 3, 3, run);
        if (!zeros && repeats && run >= 3) return add(16, 2, 3, std::min<std::size_t>(run, 6));
        return add(lengths[first], 0, 1, 1);
    }
    std::size_t add(std::uint32_t symbol, std::uint32_t extraBits, std::size_t least,
                    std::size_t run) {
        symbols_.push_back({symbol, extraBits, std::uint32_t(run - least)});
        return run;
    }

    std::size_t literals_, distances_;
    std::vector<Symbol> symbols_;
};

/// The words of one block: literals and, extra bits included, lengths and distances.
class BlockCode {
  public:
    BlockCode(const std::uint8_t* bytes, std::span<const Step> steps,
              const std::vector<std::size_t>& distances) {
        std::array<std::uint32_t, kLiteralCodes> literalCounts{};
        std::array<std::uint32_t, kDistanceCodes> distanceCounts{};
        for (const Step& step : steps) {
            for (std::uint32_t i = 0; i < step.literals; ++i) ++literalCounts[*bytes++];
            if (step.length == 0) continue;
            ++literalCounts[lengthSymbol(step.length).symbol];
            ++distanceCounts[distanceSymbol(distances[step.distance]).symbol];
            bytes += step.length;
        }
        ++literalCounts[kEndOfBlock];
        literals_ = huffmanCode(literalCounts, kLongestWord);
        distances_ = huffmanCode(distanceCounts, kLongestWord);
        for (std::size_t i = kShortest; i <= kLongest; ++i) {
            lengthWords_[i] = withExtra(literals_, lengthSymbol(i));
        }
        for (const std::size_t distance : distances) {
            distanceWords_.push_back(withExtra(distances_, distanceSymbol(distance)));
        }
    }

    void write(const std::uint8_t* bytes, std::span<const Step> steps, BitWriter& file) const {
        LengthsHeader(literals_, distances_).write(file);
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
    std::array<CodeWord, kLongest + 1> lengthWords_;
    std::vector<CodeWord> distanceWords_;
};

/// No block is longer: 14 bits a byte, its header, and what BitWriter::flush() may touch.
constexpr std::size_t kBlockBound = 2 * kBlock + 512;

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

}  // namespace

std::size_t rowDeflateBound(std::size_t size) {
    return size + kBlockBound;
}

std::size_t rowDeflate(std::span<const std::uint8_t> bytes, std::size_t rowLength,
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

}  // namespace specbake
