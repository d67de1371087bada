#pragma once

#include "upsample/blend.h"
#include "upsample/fill.h"
#include "upsample/grid_margin.h"
#include "upsample/spectrum_cache.h"

#include <specbake/core/color_census.h>
#include <specbake/core/outside.h>

#include <array>
#include <deque>
#include <optional>
#include <span>

namespace specbake::internal {

/// Where texels stand: the linear space of the texture, and the cube that the grid divides.
struct LookupSpaces {
    Imath::M33d xyzFromTexel;
    Imath::M33d xyzFromGrid;
    bool sameSpace() const { return xyzFromTexel == xyzFromGrid; }
};

/// Finds each texel's spectrum: in the grid where its cell lies in the solid, solved by itself
/// elsewhere, and a blend of both in the cells between. Just outside the grid's cube, the
/// difference between both fades out, so that there is no step at its faces. Any number of threads
/// may share it.
class SpectrumLookup {
  public:
    /// `gridNodes`: none to solve every texel by itself. The resolver must outlive the lookup.
    SpectrumLookup(std::optional<int> gridNodes, const LookupSpaces& spaces,
                   const ColorResolver& resolver);

    /// Spectra of texels that are not blends of grid nodes; what Mix points to stays put.
    using Scratch = std::deque<SolvedTexel>;
    using Color = std::array<float, 3>;

    /// The mixes of a run of texels, numbered from 0 in the census. A texel that has no spectrum
    /// counts there and gets that of black.
    void locate(std::span<const Color> colors, std::span<Mix> mixes, Scratch& scratch,
                ColorCensus& census);

    void solveNodes();
    std::size_t nodesSolved() const { return lattice_ ? lattice_->store.foundCount() : 0; }

  private:
    struct Lattice {
        Lattice(int nodes, const Imath::M33d& xyzFromGrid, const ColorResolver& resolver);
        Grid grid;
        GridMargin margin;
        NodeStore store;
    };
    struct Place {
        Mix mix;
        float margin = 0;  ///< of the grid's mix; the rest is to be solved
    };
    struct Found {
        Mix mix;
        const SolvedTexel* solved = nullptr;  ///< none: a blend of the grid's nodes alone
    };

    static constexpr std::size_t kRun = 64;

    void locateRun(std::span<const Color> colors, Mix* mixes, Scratch& scratch,
                   ColorCensus& census);
    Color gridPoint(const Color& color) const;
    Place placeInGrid(const Color& point);
    Found find(const Color& color, Scratch& scratch);
    SolvedTexel solve(const Color& color);
    SolvedTexel solveAnew(const Color& color);
    SolvedTexel solveColor(const XYZ& asked) const;
    void addFaceStep(const Color& point, NodeValues& values);

    LookupSpaces spaces_;
    std::optional<Imath::M33d> gridFromTexel_;
    const ColorResolver& resolver_;
    NodeEncoder encoder_;
    SpectrumCache cache_;
    std::unique_ptr<Lattice> lattice_;
};

}  // namespace specbake::internal
