#pragma once

namespace specbake::internal {

// The tolerances and limits of SmoothSolver's Newton iteration, one colour at a time or many.

inline constexpr double kTolerance = 1e-12;      ///< of the residual, relative to the colour
inline constexpr double kSlopeTolerance = 1e-9;  ///< of the stationarity equations, absolute
inline constexpr int kMaxIterations = 60;
inline constexpr double kLongestStep = 2;  ///< in z: tanh changes its character over about 2
/// The start is the grey of a luminance between this and 1 less this.
inline constexpr double kLeastLuminance = 1e-12;
/// Beyond |z| = 150 the smaller of s and 1 - s is below 1e-130: held there, since products of
/// smaller numbers would be subnormal, which many processors are slow at.
inline constexpr double kHeldAt = 150;
/// Pivots of the elimination are kept off zero, beside off-diagonals of 1; a Newton step needs no
/// more.
inline constexpr double kLeastPivot = 1e-12;

}  // namespace specbake::internal
