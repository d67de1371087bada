#include "mantissa.h"

#include <Imath/half.h>
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace specbake;
using namespace specbake::internal;

namespace {

double rounded(float value, int bits) {
    Imath::half half;
    std::byte bytes[sizeof half];
    storeRounded({&value, 1}, bits, bytes);
    std::memcpy(&half, bytes, sizeof half);
    return double(float(half));
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
            const double result = rounded(value, bits);
            REQUIRE(result == expected(double(float(value)), bits));
            REQUIRE(result >= 0);
            REQUIRE(result <= 1);
        }
    }
}

TEST_CASE("floats are rounded once: those between two halves too, and their ties") {
    std::mt19937_64 engine(41);
    std::uniform_real_distribution<float> size(-30, 1);
    for (int bits = 1; bits <= BakeOptions::kMostMantissaBits; ++bits) {
        CAPTURE(bits);
        for (int i = 0; i < 20000; ++i) {
            const float value = std::exp2(size(engine));
            REQUIRE(rounded(value, bits) == expected(double(value), bits));
        }
        // Just beside the middle of two results, by less than a half can tell.
        const float middle = 0.5F + std::ldexp(1.0F, -bits - 2);
        for (const float value :
             {std::nextafter(middle, 0.0F), middle, std::nextafter(middle, 1.0F)}) {
            CHECK(rounded(value, bits) == expected(double(value), bits));
        }
    }
}
