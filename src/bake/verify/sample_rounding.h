#pragma once

#include <specbake/image/image_types.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {

/// How far a stored sample v' may lie from the value v that was rounded to it:
/// |v' − v| <= relative |v'| + absolute.
struct SampleRounding {
    double relative = 0;
    double absolute = 0;

    double of(double stored) const { return relative * std::abs(stored) + absolute; }
};

/// Of samples with `bits` bits of mantissa, rounded to nearest: half a unit in the last place,
/// which is 2^-(bits + 1) of the power of two below v'; of halves below 2^-14, of that.
inline SampleRounding roundingOf(TexelType type, int bits) {
    if (type == TexelType::half) {
        const double unit = std::ldexp(1.0, -(std::clamp(bits, 1, 10) + 1));
        return {unit, std::ldexp(unit, -14)};
    }
    return {0x1p-24, 0};
}

}  // namespace specbake::internal
