#pragma once

#include "methods/published/jakob2019.h"

#include <vector>

namespace specbake::bench {

/// The table of Jakob & Hanika 2019 (jakob2019.h): coefficients at nodes of a grid in RGB, three
/// cubes of resolution³, one for each largest component. Along the axis of the largest component z
/// the nodes are at smoothstep(smoothstep(k / (n − 1))), dense near 0 and 1; the two others, in
/// cyclic order after the largest, are indexed evenly as fractions of it. Coefficients are
/// interpolated trilinearly, in float, as the authors' lookup does; greys are a closed form.
///
/// | quantity | domain    | scale                            |
/// |----------|-----------|----------------------------------|
/// | RGB      | [0, 1]    | linear, of the frame; clamped    |
/// | spectrum | (0, 1)    | 1 = perfect reflector            |
class Jakob2019Table : public Method {
  public:
    static constexpr int kAuthorsResolution = 64;
    /// 8 <= resolution.
    Jakob2019Table(Frame frame, int resolution = kAuthorsResolution);

    /// 3 resolution³ fits, each from its neighbour's coefficients.
    void setUp() override;
    Reconstruction reconstruct(const XYZ& color) const override;
    void reconstructTexels(std::span<const Imath::V3f> rgb,
                           std::span<float> spectra) const override;

    /// The node's colour: largest component 0, 1, 2; i, j the fractions, k along the largest.
    RGB nodeColor(int largest, int i, int j, int k) const;

  private:
    using Coefficients = Imath::V3f;
    std::size_t index(int largest, int i, int j, int k) const;
    void fitLine(int largest, int i, int j);
    Coefficients lookUp(const Imath::V3f& rgb) const;

    int resolution_;
    std::vector<float> scale_;  ///< nodes of the largest component, ascending, 0 to 1
    std::vector<Coefficients> nodes_;
};

}  // namespace specbake::bench
