#include "half_bits.h"

#include <Imath/half.h>

#include <algorithm>

namespace specbake::bench {

std::uint16_t halfPattern(double value, int bits) {
    const std::uint16_t pattern = Imath::half(static_cast<float>(value)).bits();
    const int dropped = kHalfBits - bits;
    if (dropped == 0) return pattern;
    // On the pattern, since a carry into the exponent is right there.
    const unsigned half = 1U << (dropped - 1);
    const unsigned odd = (pattern >> dropped) & 1U;
    return static_cast<std::uint16_t>((pattern + half - 1 + odd) >> dropped << dropped);
}

Spectrum roundedToBits(const Spectrum& s, int bits) {
    Spectrum result;
    std::ranges::transform(s, result.begin(), [bits](double value) {
        Imath::half half;
        half.setBits(halfPattern(value, bits));
        return double(float(half));
    });
    return result;
}

}  // namespace specbake::bench
