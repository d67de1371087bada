#pragma once

#include <specbake/core/wavelengths.h>

#include <Imath/ImathVec.h>

#include <array>

namespace specbake::internal {

/// The symmetric system
///
///     | H  Jᵀ | | x |     | a |
///     | J  0  | | y |  =  | b |
///
/// with H tridiagonal (kBandCount square, off-diagonals -1) and J three rows, solved in
/// O(kBandCount). H alone may be singular (a constant x costs nothing): its last unknown is
/// therefore eliminated together with the three of y, by a dense 4x4 solve with pivoting.
struct BorderedTridiagonal {
    std::array<double, kBandCount> diagonal;    ///< of H
    std::array<Imath::V3d, kBandCount> border;  ///< columns of J
};

struct BorderedVector {
    std::array<double, kBandCount> x;
    Imath::V3d y;
};

/// Overwrites `right` by the solution. False if the system is singular.
[[nodiscard]] bool solveInPlace(const BorderedTridiagonal& system, BorderedVector& right);

}  // namespace specbake::internal
