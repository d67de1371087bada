#pragma once

#include "method.h"

#include <vector>

namespace specbake::bench {

/// Weighted bounded maximum entropy: the s that maximises
///
///     Σ p_m H(s_m),  H(s) = −s ln s − (1 − s) ln (1 − s),  p_m = X_m + Y_m + Z_m of w_m
///
/// subject to (1). Stationarity gives s_m = σ(μ·w_m / p_m), σ the logistic function: μ weighs the
/// chromaticity of each band. The dual D(μ) = Σ p_m ln(1 + exp(μ·v_m)) − μ·t, v_m = w_m / p_m, is
/// convex with gradient W s − t: three unknowns, Newton with a line search. The moments' form of
/// C. Peters et al., "Using Moments to Represent Bounded Signals for Spectral Rendering", ACM
/// Transactions on Graphics 38(4), 2019, with the colour-matching functions for their moments.
///
/// | quantity | domain       | scale                     |
/// |----------|--------------|---------------------------|
/// | XYZ      | the solid    | Y of white = 1            |
/// | spectrum | (0, 1)       | 1 = perfect reflector     |
class MaxEntropy : public Method {
  public:
    explicit MaxEntropy(Frame frame) : Method({"max entropy", ""}, std::move(frame)) {}
    void setUp() override;
    /// Says that it did not converge where max |W s − t| > 1e-9 is left.
    Reconstruction reconstruct(const XYZ& color) const override;

  private:
    struct Band {
        Imath::V3d w, chromaticity;
        double weight;
    };
    struct State;
    State stateAt(const Imath::V3d& multipliers, const XYZ& target) const;

    std::vector<Band> bands_;
};

}  // namespace specbake::bench
