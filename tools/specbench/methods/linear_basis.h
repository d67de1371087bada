#pragma once

#include "method.h"

#include <array>

namespace specbake::bench {

/// Three spectra b_i; a colour's spectrum is s = Σ c_i b_i, with c its linear RGB.
using Basis = std::array<Spectrum, 3>;

/// The b'_i spanned by three independent functions f_j for which s = Σ c_i b'_i has exactly the
/// colour of RGB c in `frame`: b' = M (F W^T)⁻¹ F, with M the frame's matrix (rows: primaries) and
/// F the functions, by (1). Throws ArgumentError if the functions' colours lie in a plane.
Basis basisSpannedBy(const Basis& functions, const Frame& frame);

/// A method that is a linear map from RGB to 81 values, nothing clamped.
class LinearMethod : public Method {
  public:
    LinearMethod(MethodName name, Frame frame) : Method(std::move(name), std::move(frame)) {}

    Reconstruction reconstruct(const XYZ& color) const override;
    void reconstructTexels(std::span<const Imath::V3f> rgb,
                           std::span<float> spectra) const override;

    const Basis& basis() const { return basis_; }

  protected:
    void setBasis(const Basis& basis);

  private:
    Basis basis_{};
    std::array<std::array<float, kBandCount>, 3> floatBasis_{};
};

}  // namespace specbake::bench
