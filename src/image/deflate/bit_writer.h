#pragma once

#include "deflate/huffman.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace specbake::internal {

/// Writes bits from the lowest of each byte up, as deflate does. At most kMostBits between two
/// calls of flush(), each of which writes 8 bytes, of which the whole ones count.
class BitWriter {
  public:
    static constexpr std::uint32_t kMostBits = 64 - 7;

    explicit BitWriter(std::uint8_t* to) : to_(to) {}

    void put(const CodeWord& word) { put(word.bits, word.length); }
    void put(std::uint64_t bits, std::uint32_t count) {
        pending_ |= bits << count_;
        count_ += count;
    }
    void flush() {
        for (std::size_t i = 0; i < 8; ++i) to_[i] = std::uint8_t(pending_ >> 8 * i);
        to_ += count_ / 8;
        pending_ >>= count_ / 8 * 8;
        count_ %= 8;
    }
    /// Fills the last byte with zeros.
    void finish() {
        flush();
        if (count_ > 0) ++to_;
        count_ = 0;
        pending_ = 0;
    }
    std::uint8_t* position() const { return to_; }

  private:
    std::uint8_t* to_;
    std::uint64_t pending_ = 0;
    std::uint32_t count_ = 0;  ///< below 8 after flush()
};

}  // namespace specbake::internal
