#include "mantissa.h"

#include <Imath/half.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace specbake::internal {
namespace {

/// The nearest multiple of q = 2^(e - bits), 2^e being the power of 2 below the value, or 2^-14,
/// below which halves have fixed steps. Floats of [2^23 q, 2^24 q) are the multiples of q: so the
/// sum with 2^23 q rounds to one, by the processor's own rule, and the difference is exact.
float rounded(float value, std::uint32_t bits) {
    constexpr std::uint32_t mantissa = 23;
    constexpr std::uint32_t leastExponent = 127 - 14;
    const std::uint32_t exponent =
        std::max(std::bit_cast<std::uint32_t>(value) >> mantissa, leastExponent);
    const auto large = std::bit_cast<float>((exponent + mantissa - bits) << mantissa);
    return (value + large) - large;
}

}  // namespace

void storeRounded(std::span<const float> values, int bits, std::byte* halves) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Imath::half half = rounded(values[i], std::uint32_t(bits));
        std::memcpy(halves + i * sizeof half, &half, sizeof half);
    }
}

}  // namespace specbake::internal
