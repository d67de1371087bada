#pragma once

#include "solve/free_set.h"

#include <Imath/ImathVec.h>

#include <array>

namespace specbake::internal {

using Weights = std::array<Imath::V3d, kBandCount>;

/// The eigen-decomposition of G = W P W^T = sum over the free components of w w^T: what the matrix
/// of (18) is for the residual r = W s - t. G is 3 x 3, symmetric and non-negative.
struct FaceModes {
    Imath::V3d rates;                   ///< eigenvalues, ascending, >= 0
    std::array<Imath::V3d, 3> vectors;  ///< orthonormal, in the same order

    /// Rates up to this are rounding errors (the singular values of W P, whose squares they are,
    /// are exact to a few eps of the largest): the face does not reach that direction.
    double cutoff() const { return 1e-14 * 1e-14 * rates.z; }

    /// G^-1 r, without the directions that the face does not reach: the least-norm correction
    /// of the free components is then -w_m . (G^-1 r).
    Imath::V3d solve(const Imath::V3d& residual) const;
};

FaceModes faceModes(const Weights& weights, const FreeSet& free);

}  // namespace specbake::internal
