// Compiled once for each instruction set by foreach_target.h; split() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "deflate/row_matcher.cpp"
#include "deflate/row_matcher.h"

#include "deflate/deflate_symbols.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kWordBits = ByteSet::kWordBits;
constexpr std::size_t kMostDistances = RowMatcher::kMostDistances;
using EqualSets = RowMatcher::EqualSets;

/// Which of the 64 bytes at `a` equal those at `b`.
HWY_INLINE std::uint64_t equalBytes(const std::uint8_t* a, const std::uint8_t* b) {
    constexpr hn::CappedTag<std::uint8_t, kWordBits> bytes;
    constexpr std::size_t lanes = hn::MaxLanes(bytes);
    std::uint64_t equal = 0;
    if constexpr (lanes < 8) {
        for (std::size_t i = 0; i < 64; ++i) equal |= std::uint64_t(a[i] == b[i]) << i;
    } else {
        std::array<std::uint8_t, 16> bits;  // StoreMaskBits() may write 8 bytes each time
        for (std::size_t i = 0; i < 64; i += lanes) {
            const auto same = hn::Eq(hn::LoadU(bytes, a + i), hn::LoadU(bytes, b + i));
            hn::StoreMaskBits(bytes, same, bits.data() + i / 8);
        }
        for (std::size_t i = 0; i < 8; ++i) equal |= std::uint64_t(bits[i]) << 8 * i;
    }
    return equal;
}

/// The bytes of a block that equal the one at a distance before them.
void findEqual(const std::uint8_t* bytes, std::size_t begin, std::size_t end, std::size_t distance,
               ByteSet& equal) {
    for (std::size_t w = 0; w < kDeflateBlock / kWordBits; ++w) {
        const std::size_t first = begin + w * kWordBits;
        const std::size_t last = std::min(first + kWordBits, end);
        if (first >= distance && last == first + kWordBits) {
            equal.words[w] = equalBytes(bytes + first, bytes + first - distance);
            continue;
        }
        equal.words[w] = 0;
        for (std::size_t i = std::max(first, distance); i < last; ++i) {
            equal.words[w] |= std::uint64_t(bytes[i] == bytes[i - distance]) << (i - first);
        }
    }
}

/// The bytes at which `length` bytes of a set begin.
ByteSet startsOfRuns(const ByteSet& set, std::size_t length) {
    ByteSet starts = set;
    auto& w = starts.words;
    for (std::size_t have = 1; have < length;) {
        const std::size_t more = std::min(have, length - have);
        for (std::size_t i = 0; i + 1 < w.size(); ++i) {
            w[i] &= w[i] >> more | w[i + 1] << (kWordBits - more);
        }
        have += more;
    }
    return starts;
}

/// How many bytes of a set follow each other from byte `i` on, `most` at most.
std::size_t runAt(const ByteSet& set, std::size_t i, std::size_t most) {
    std::size_t length = 0;
    std::size_t more = kWordBits;
    for (; more == kWordBits && length < most; length += more) {
        more = std::size_t(std::countr_one(set.from(i + length)));
    }
    return std::min(length, most);
}

/// The longest match at byte `i`; of equally long ones, the first distance's.
Step longestMatch(const EqualSets& equal, std::size_t i, std::size_t most) {
    std::size_t best = 0;  // length, and with it the distance: the larger is the better
    for (std::size_t d = 0; d < kMostDistances; ++d) {
        const auto length = std::size_t(std::countr_one(equal[d].from(i)));
        best = std::max(best, length * kMostDistances + (kMostDistances - 1 - d));
    }
    if (best / kMostDistances < kWordBits) {
        const std::size_t distance = kMostDistances - 1 - best % kMostDistances;
        return {0, std::uint16_t(best / kMostDistances), std::uint16_t(distance)};
    }
    Step longest = {0, 0, 0};
    for (std::size_t d = 0; d < kMostDistances; ++d) {
        const std::size_t length = runAt(equal[d], i, most);
        if (length > longest.length) longest = {0, std::uint16_t(length), std::uint16_t(d)};
    }
    return longest;
}

/// A block of `count` bytes, from what equals what and where matches begin.
void addSteps(const EqualSets& equal, const ByteSet& starts, std::size_t count,
              std::vector<Step>& steps) {
    std::size_t literalsFrom = 0;
    for (std::size_t i = 0; i < count;) {
        const std::uint64_t next = starts.from(i);
        i += std::size_t(std::countr_zero(next));
        if (next == 0) continue;
        Step step = longestMatch(equal, i, std::min(count - i, kLongestMatch));
        step.literals = std::uint32_t(i - literalsFrom);
        steps.push_back(step);
        literalsFrom = i += step.length;
    }
    steps.push_back({std::uint32_t(count - literalsFrom), 0, 0});
}

void splitBlock(std::span<const std::uint8_t> bytes, std::span<const std::size_t> distances,
                std::size_t begin, std::size_t shortest, EqualSets& equal,
                std::vector<Step>& steps) {
    ByteSet starts;
    for (std::size_t d = 0; d < distances.size(); ++d) {
        findEqual(bytes.data(), begin, bytes.size(), distances[d], equal[d]);
        const ByteSet ofDistance = startsOfRuns(equal[d], shortest);
        for (std::size_t w = 0; w < starts.words.size(); ++w) {
            starts.words[w] |= ofDistance.words[w];
        }
    }
    addSteps(equal, starts, bytes.size() - begin, steps);
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(splitBlock);
}  // namespace

RowMatcher::RowMatcher(std::span<const std::uint8_t> bytes, std::size_t rowLength,
                       std::size_t rowsBack)
    : bytes_(bytes), distances_({1}) {
    for (std::size_t rows = 1; rows <= rowsBack && rows * rowLength <= kDeflateWindow; ++rows) {
        distances_.push_back(rows * rowLength);
    }
}

void RowMatcher::split(std::size_t begin, std::size_t end, std::size_t shortest,
                       std::vector<Step>& steps) {
    steps.clear();
    HWY_DYNAMIC_DISPATCH(splitBlock)
    (bytes_.first(end), distances_, begin, shortest, equal_, steps);
}

}  // namespace specbake::internal
#endif
