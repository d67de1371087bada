#include "mantissa.h"

#include <Imath/half.h>
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <vector>

using namespace specbake;
using namespace specbake::internal;

namespace {

Imath::half rounded(Imath::half value, int bits) {
    std::vector<std::byte> bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    roundMantissa(bytes, bits);
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

/// By the definition: the nearest multiple of 2^(e - bits), 2^e the power of two below the value
/// (2^-14 for denormals); ties to even.
double expected(double value, int bits) {
    if (value == 0) return 0;
    const int exponent = std::max(std::ilogb(value), -14);
    const double unit = std::ldexp(1.0, exponent - bits);
    return std::nearbyint(value / unit) * unit;
}

}  // namespace

TEST_CASE("every half in [0, 1], to any number of bits, is rounded as defined") {
    for (int bits = 1; bits <= BakeOptions::kMostMantissaBits; ++bits) {
        CAPTURE(bits);
        Imath::half value;
        for (unsigned code = 0; code <= 0x3c00; ++code) {
            value.setBits(static_cast<unsigned short>(code));
            const double result = double(float(rounded(value, bits)));
            REQUIRE(result == expected(double(float(value)), bits));
            REQUIRE(result >= 0);
            REQUIRE(result <= 1);
        }
    }
}
