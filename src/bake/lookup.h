#pragma once

#include "texel_census.h"

#include <specbake/core/blend.h>
#include <specbake/core/fill.h>

#include <array>
#include <deque>
#include <span>

namespace specbake {

/// Finds each texel's spectrum: in the grid where its cell lies in the solid, else by solving it.
/// Any number of threads may share it.
class SpectrumLookup {
  public:
    /// `xyzFromTexel` takes a linear texel to XYZ; `solver` must outlive the lookup.
    SpectrumLookup(int gridNodes, const Imath::M33d& xyzFromTexel, const Solver& solver);

    /// Spectra of texels that are not blends of grid nodes; what Mix points to stays put.
    using Scratch = std::deque<NodeValues>;

    /// The mixes of a run of texels, the first of which is number `firstTexel` of the image.
    /// A texel that has no spectrum counts in the census and gets that of black.
    void locate(std::span<const std::array<float, 3>> colors, std::size_t firstTexel,
                std::span<Mix> mixes, Scratch& scratch, TexelCensus& census);

    std::size_t nodesSolved() const { return store_.foundCount(); }

  private:
    bool locateInGrid(const std::array<float, 3>& color, Mix& mix);
    Mix solve(const std::array<float, 3>& color, std::size_t texel, Scratch& scratch,
              TexelCensus& census) const;

    Grid grid_;
    Imath::M33d xyzFromTexel_;
    const Solver& solver_;
    NodeEncoder encoder_;
    NodeStore store_;
};

}  // namespace specbake
