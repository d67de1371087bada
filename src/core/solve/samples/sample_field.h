#pragma once

#include <specbake/core/spectrum.h>

#include <Imath/ImathVec.h>

#include <vector>

namespace specbake::internal {

/// How far a sample is heard, in units of place.h (about those of CIELAB), and how much more its
/// own colour counts than those about it.
struct FieldShape {
    double range = 8;     ///< ρ > 0
    double weight = 0.1;  ///< ω >= 0

    /// φ(r) = exp(−r/ρ) + ω exp(−r): positive definite, so that (M18) has one solution; continuous,
    /// with finite slope; 0 far away.
    double at(double distance) const;
};

/// The spectra b_k at the places p_k, carried on to all places (kriging with a covariance φ):
///
///     v(p) = Σ c_k φ(|p − p_k|),   v(p_k) = b_k                                  (M18)
///
/// It is linear in the b_k: if those have no colour, v has none.
class SampleField {
  public:
    /// As many values as places. Places differ; one that equals another to rounding is left out.
    SampleField(std::vector<Imath::V3d> places, const std::vector<Spectrum>& values,
                const FieldShape& shape);

    Spectrum at(const Imath::V3d& place) const;

    /// What the others say at each place: b_k − c_k / (Φ⁻¹)_kk, in closed form.
    std::vector<Spectrum> leftOut(const std::vector<Spectrum>& values) const;

  private:
    double& factor(std::size_t row, std::size_t column) { return factor_[row * size() + column]; }
    double factor(std::size_t row, std::size_t column) const {
        return factor_[row * size() + column];
    }
    std::size_t size() const { return places_.size(); }
    void factorise();
    void solveInPlace();
    double inverseDiagonal(std::size_t k) const;

    FieldShape shape_;
    std::vector<Imath::V3d> places_;
    std::vector<double> factor_;          ///< L of Φ = L Lᵀ, row by row
    std::vector<Spectrum> coefficients_;  ///< c_k
};

}  // namespace specbake::internal
