#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/spectrum.h>

#include <array>
#include <cstddef>
#include <optional>

/// The six equations W s = t of a colour under two lights: X, Y, Z under the first, then under the
/// second.
namespace specbake::internal {

inline constexpr std::size_t kSix = 6;
using Six = std::array<double, kSix>;

/// The columns of W.
using SixWeights = std::array<Six, kBandCount>;
SixWeights sixWeights(const Observer& first, const Observer& second);

/// W s
Six colorsOf(const SixWeights& weights, const Spectrum& s);

Six operator-(const Six& a, const Six& b);

/// max |v_i|; NaN if a component is.
double largestOf(const Six& v);

/// A 6×6 matrix, row by row.
using SixMatrix = std::array<Six, kSix>;

/// x with A x = b by elimination with pivoting; none if A is singular.
std::optional<Six> solveSix(SixMatrix A, Six b);

}  // namespace specbake::internal
