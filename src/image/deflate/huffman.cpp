#include "deflate/huffman.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace specbake::internal {
namespace {

/// A tree's node: a symbol, or the parent of two nodes.
struct Node {
    std::uint32_t count;
    std::uint32_t parent;
};

/// The leaves of Huffman's tree by rising count, with their depths in `count`'s place.
///
/// Leaves and inner nodes both arise in rising order, so that the two rarest are always at the
/// heads of two queues (J. van Leeuwen 1976).
std::vector<std::uint32_t> depths(const std::vector<std::uint32_t>& risingCounts) {
    const std::size_t leaves = risingCounts.size();
    std::vector<Node> nodes;
    nodes.reserve(2 * leaves);
    for (const std::uint32_t count : risingCounts) nodes.push_back({count, 0});
    std::size_t leaf = 0;
    std::size_t inner = leaves;
    const auto rarest = [&] {
        const bool takeLeaf =
            leaf < leaves && (inner == nodes.size() || nodes[leaf].count <= nodes[inner].count);
        return takeLeaf ? leaf++ : inner++;
    };
    while (nodes.size() < 2 * leaves - 1) {
        const std::size_t a = rarest();
        const std::size_t b = rarest();
        nodes[a].parent = nodes[b].parent = std::uint32_t(nodes.size());
        nodes.push_back({nodes[a].count + nodes[b].count, 0});
    }
    std::vector<std::uint32_t> depth(nodes.size());
    for (std::size_t i = nodes.size() - 1; i-- > 0;) depth[i] = depth[nodes[i].parent] + 1;
    depth.resize(leaves);
    return depth;
}

/// Halved counts make a flatter tree; counts that are all 1 make the flattest.
std::vector<std::uint32_t> depthsUpTo(std::uint32_t longest, std::vector<std::uint32_t> counts) {
    auto result = depths(counts);
    while (*std::max_element(result.begin(), result.end()) > longest) {
        for (std::uint32_t& count : counts) count = (count + 1) / 2;
        result = depths(counts);
    }
    return result;
}

/// A word of `length` bits, 1 to 32, with its bits in the other order.
std::uint32_t reversed(std::uint32_t word, std::uint32_t length) {
    word = (word & 0x55555555) << 1 | (word >> 1 & 0x55555555);
    word = (word & 0x33333333) << 2 | (word >> 2 & 0x33333333);
    word = (word & 0x0F0F0F0F) << 4 | (word >> 4 & 0x0F0F0F0F);
    word = (word & 0x00FF00FF) << 8 | (word >> 8 & 0x00FF00FF);
    return (word << 16 | word >> 16) >> (32 - length);
}

void assignWords(std::vector<CodeWord>& code, std::uint32_t longest) {
    std::vector<std::uint32_t> next(longest + 2);  // first how many words are one bit shorter
    for (const CodeWord& word : code) next[word.length + 1] += word.length > 0 ? 1 : 0;
    for (std::uint32_t length = 1; length <= longest; ++length) {
        next[length] = (next[length - 1] + next[length]) << 1;
    }
    for (CodeWord& word : code) {
        if (word.length > 0) word.bits = reversed(next[word.length]++, word.length);
    }
}

}  // namespace

std::vector<CodeWord> huffmanCode(std::span<const std::uint32_t> counts, std::uint32_t longest) {
    std::vector<std::uint64_t> symbols;  // with their counts above them, so that they sort by both
    for (std::uint32_t s = 0; s < counts.size(); ++s) {
        if (counts[s] > 0) symbols.push_back(std::uint64_t(counts[s]) << 32 | s);
    }
    std::sort(symbols.begin(), symbols.end());
    std::vector<CodeWord> code(counts.size());
    if (symbols.size() == 1) {
        code[std::uint32_t(symbols[0])].length = 1;
    } else if (symbols.size() > 1) {
        std::vector<std::uint32_t> rising;
        for (const std::uint64_t s : symbols) rising.push_back(std::uint32_t(s >> 32));
        const auto lengths = depthsUpTo(longest, std::move(rising));
        for (std::size_t i = 0; i < symbols.size(); ++i) {
            code[std::uint32_t(symbols[i])].length = lengths[i];
        }
    }
    assignWords(code, longest);
    return code;
}

}  // namespace specbake::internal
