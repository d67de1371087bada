#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace specbake::internal {

/// A code word as deflate writes it: first bit of the word in the lowest bit.
struct CodeWord {
    std::uint32_t bits = 0;
    std::uint32_t length = 0;  ///< 0: the symbol does not occur
};

/// Huffman's prefix code for symbols that occur so often, no word longer than `longest` bits; the
/// canonical one of its lengths (RFC 1951, 3.2.2). A symbol that is alone gets a word of one bit.
/// The counts' number must be below 2^longest.
std::vector<CodeWord> huffmanCode(std::span<const std::uint32_t> counts, std::uint32_t longest);

}  // namespace specbake::internal
