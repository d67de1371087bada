#pragma once

#include "linear_basis.h"

namespace specbake::bench {

/// The exact spectrum nearest to a grey: the g and s that minimise Σ (s_m − g)² subject to (1),
///
///     s = g + W^T G⁻¹ (t − g W·1),   G = W W^T,   g = (W·1)·G⁻¹t / (W·1)·G⁻¹(W·1),
///
/// linear in t; then clipped to [0, 1] once, which changes the colour. The least-squares solution
/// of the many that go back to J. B. Cohen, W. E. Kappauf, "Metameric color stimuli, fundamental
/// metamers, and Wyszecki's metameric blacks", American Journal of Psychology 95(4), 1982.
///
/// | quantity | domain       | scale                     |
/// |----------|--------------|---------------------------|
/// | XYZ      | any          | Y of white = 1            |
/// | spectrum | [0, 1]       | 1 = perfect reflector     |
class NearestGrey : public LinearMethod {
  public:
    enum class Bounds { clipped, none };
    NearestGrey(Frame frame, Bounds bounds);
    void setUp() override;
    Reconstruction reconstruct(const XYZ& color) const override;
    void reconstructTexels(std::span<const Imath::V3f> rgb,
                           std::span<float> spectra) const override;

  private:
    Bounds bounds_;
};

}  // namespace specbake::bench
