#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/spectrum.h>

#include <Imath/ImathVec.h>

#include <array>

namespace specbake::internal {

/// The eigen-analysis of the operator A = Σ |w⟩⟨w| over X, Y, Z (paper, section 2).
///
/// Of its 81 eigenvalues three are not 0: those of the 3 x 3 Gram matrix ⟨w|w⟩ (9). Spectra here
/// are plain 81-vectors, not reflectances.
class EigenAnalysis {
  public:
    explicit EigenAnalysis(const Observer& observer);

    /// Λ_1 >= Λ_2 >= Λ_3 > 0.
    const std::array<double, 3>& values() const { return values_; }

    /// φ_k of (10), of unit length. The largest component is positive.
    const std::array<Spectrum, 3>& vectors() const { return vectors_; }

    /// s*, the first three terms of (12): the shortest s with W s = t. It may leave [0, 1].
    Spectrum shortestSolution(const XYZ& color) const;

  private:
    std::array<double, 3> values_{};
    std::array<Imath::V3d, 3> coefficients_;  ///< α^k of (10)
    std::array<Spectrum, 3> vectors_{};
};

}  // namespace specbake::internal
