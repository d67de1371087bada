#include "mantissa.h"

#include <cstdint>
#include <cstring>

namespace specbake::internal {

/// On a half's bits as an integer: a carry out of the mantissa raises the exponent, as it should.
void roundMantissa(std::span<std::byte> halves, int bits) {
    const int dropped = BakeOptions::kMostMantissaBits - bits;
    if (dropped <= 0) return;
    const unsigned belowHalf = (1U << (dropped - 1)) - 1;
    const unsigned kept = ~((1U << dropped) - 1);
    for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
        std::uint16_t half;
        std::memcpy(&half, &halves[i], sizeof half);
        const unsigned odd = unsigned(half) >> dropped & 1U;
        half = std::uint16_t((half + belowHalf + odd) & kept);
        std::memcpy(&halves[i], &half, sizeof half);
    }
}

}  // namespace specbake::internal
