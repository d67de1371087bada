#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace specbake::internal {

inline constexpr std::size_t kShortestMatch = 3;
inline constexpr std::size_t kLongestMatch = 258;
inline constexpr std::size_t kEndOfBlock = 256;
inline constexpr std::size_t kLiteralCodes = 286;
inline constexpr std::size_t kDistanceCodes = 30;

/// A length or distance as deflate writes it: a symbol, then extra bits (RFC 1951, 3.2.5).
struct Symbol {
    std::uint32_t symbol, extraBits, extra;
};

/// Both scales: beyond the first steps, 2^stepBits symbols to each power of two.
inline Symbol onScale(std::uint32_t value, std::uint32_t stepBits) {
    const auto bits = std::uint32_t(std::bit_width(value));
    if (bits <= stepBits + 1) return {value, 0, 0};
    const std::uint32_t extraBits = bits - stepBits - 1;
    const std::uint32_t step = value >> extraBits;  // its highest bit is 2^stepBits
    return {(extraBits << stepBits) + step, extraBits, value & ((1U << extraBits) - 1)};
}

inline Symbol lengthSymbol(std::size_t length) {
    if (length == kLongestMatch) return {285, 0, 0};
    Symbol s = onScale(std::uint32_t(length) - 3, 2);
    s.symbol += 257;
    return s;
}

inline Symbol distanceSymbol(std::size_t distance) {
    return onScale(std::uint32_t(distance) - 1, 1);
}

}  // namespace specbake::internal
