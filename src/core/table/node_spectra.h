#pragma once

#include "upsample/grid.h"

#include <specbake/core/upsampler.h>

#include <cstdint>
#include <vector>

namespace specbake::internal {

/// What stands at the nodes of a table's grid.
struct NodeSpectra {
    std::vector<Spectrum> spectrum;        ///< by number of node
    std::vector<std::uint8_t> attainable;  ///< 1 where the solid holds the node's colour, else 0

    /// Whether the solid holds the whole cube.
    bool areAttainable() const;
    /// Whether a blend needs a node that the solid does not hold.
    bool isCut(const GridSimplex& simplex) const {
        for (std::size_t k = 0; k < 4; ++k) {
            if (simplex.weight[k] > 0 && attainable[simplex.node[k]] == 0) return true;
        }
        return false;
    }
};

/// The spectra of a grid's nodes. Those that the solid does not hold get that of the nearest
/// colour.
NodeSpectra nodeSpectra(const Grid& grid, const Upsampler& upsampler);

/// Moves a spectrum, by the shortest way, to where it has the colour: s + Wᵀ(WWᵀ)⁻¹(t − W s).
class ColorCorrection {
  public:
    explicit ColorCorrection(const Observer& observer);
    void apply(Spectrum& spectrum, const XYZ& color) const;

  private:
    const Observer& observer_;
    Imath::M33d inverseGram_;
};

}  // namespace specbake::internal
