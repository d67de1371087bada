#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace specbake::internal {

/// The farthest that deflate looks back.
inline constexpr std::size_t kDeflateWindow = 32768;

/// Compresses rows that resemble the rows before them into a zlib stream (RFC 1950, 1951).
///
/// Matches are looked for at a few distances alone: 1, and 1 to `rowsBack` rows. Planes of
/// neighbouring wavelengths repeat each other at just these, so that no search finds much more;
/// without one, this is several times as fast. The bytes are the same on every processor.
///
/// `rowLength`: 1 to kDeflateWindow; `rowsBack`: 1 to 3 (rows beyond the window are left out).
/// Returns the stream's size, or 0 if it would be larger than `bytes`. `packed` holds at least
/// rowDeflateBound(bytes.size()) bytes.
std::size_t rowDeflate(std::span<const std::uint8_t> bytes, std::size_t rowLength,
                       std::size_t rowsBack, std::span<std::uint8_t> packed);

/// Bytes that share a Huffman code.
inline constexpr std::size_t kDeflateBlock = 65536;

/// A block that does not shrink is noticed when it is written: 14 bits a byte, and its header.
constexpr std::size_t rowDeflateBound(std::size_t size) {
    return size + 2 * kDeflateBlock + 512;
}

}  // namespace specbake::internal
