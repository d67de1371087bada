#pragma once

#include <Imath/ImathVec.h>

#include <optional>

namespace specbake::internal {

/// One component of the closed form (19), a sum of three decaying exponentials:
///
///     value(t) = start + sum_k amplitude_k (exp(-rate_k t) - 1),     0 <= rate_1 <= rate_2 <=
///     rate_3
struct Decay {
    double start = 0;
    Imath::V3d amplitudes;
    Imath::V3d rates;

    double value(double time) const;
};

struct Exit {
    double time = 0;
    double bound = 0;  ///< 0 or 1
};

/// The first time in [0, end] at which the decay leaves [0, 1]; none if it stays. Starts inside.
///
/// No exit is missed: the slope, divided by exp(-rate_1 t), is a constant plus two exponentials,
/// whose own slope has at most one zero, in closed form. So the slope has at most two zeros, one
/// in each piece between them, and between those zeros the value is monotone: it leaves [0, 1]
/// within a piece exactly if it is outside at the piece's end.
std::optional<Exit> firstExit(const Decay& decay, double end);

}  // namespace specbake::internal
