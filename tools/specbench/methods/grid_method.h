#pragma once

#include "method.h"

#include <specbake/core/upsampler.h>

#include <memory>
#include <optional>

namespace specbake::bench {

/// A solver of specbake through the lookup grid over the frame's RGB cube, as the library ships it
/// (upsampler.h), with all nodes solved beforehand.
///
/// | quantity | domain    | scale                                        |
/// |----------|-----------|----------------------------------------------|
/// | RGB      | any       | linear; the grid holds [0, 1]                |
/// | spectrum | as solver | floats: exact to 24 bits                     |
class GridMethod : public Method {
  public:
    /// `solver` names the family; nodes an axis as UpsamplerOptions takes them.
    GridMethod(MethodName solver, Frame frame, std::shared_ptr<const Solver> direct, int nodes);

    void setUp() override;
    bool cubeOnly() const override { return true; }  // outside, it is the solver
    Reconstruction reconstruct(const XYZ& color) const override;
    void reconstructTexels(std::span<const Imath::V3f> rgb,
                           std::span<float> spectra) const override;

    /// Memory of all nodes.
    std::size_t bytes() const;

  private:
    std::shared_ptr<const Solver> solver_;
    int nodes_;
    std::optional<Upsampler> upsampler_;
    SampleSelection bands_ = SampleSelection::bands();
};

}  // namespace specbake::bench
