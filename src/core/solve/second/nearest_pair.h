#pragma once

#include "solve/second/six.h"

#include <optional>

namespace specbake::internal {

/// The reflectance that keeps a colour under the first light and comes as near as any can to one
/// under the second, in XYZ:
///
///     min ½ |W₂ s − t₂|²   subject to   W₁ s = t₁,   0 <= s <= 1                 (M20)
///
/// a convex problem, by the primal-dual interior-point method (S. J. Wright, "Primal-dual
/// interior-point methods", SIAM, 1997), six equations a step. Where colours are possible together,
/// the distance comes out below 1e-8; else the spectrum is nearly the only one, of steps between 0
/// and 1.
///
/// `start` in [0, 1] has the colour t₁. None where t₁ is not met to 1e-12: so near to white or
/// black that there is nothing to choose.
std::optional<Spectrum> nearestPair(const SixWeights& weights, const Spectrum& start,
                                    const Six& target);

}  // namespace specbake::internal
