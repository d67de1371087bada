#pragma once

#include "upsample/lattice.h"
#include "upsample/lookup_spaces.h"
#include "upsample/texel_solver.h"

#include <specbake/core/color_census.h>
#include <specbake/core/outside.h>

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace specbake::internal {

/// Finds each texel's spectrum: in the grid where its cell lies in the solid, solved by itself
/// elsewhere, and a blend of both in the cells between. Any number of threads may share it.
class SpectrumLookup {
  public:
    /// `gridNodes`: none to solve every texel by itself. The resolver must outlive the lookup.
    SpectrumLookup(std::optional<int> gridNodes, const LookupSpaces& spaces,
                   const ColorResolver& resolver, const NodeEncoder& encoder);

    /// Spectra of texels that are not blends of grid nodes; what Mix points to stays put.
    using Scratch = std::deque<SolvedTexel>;
    using Color = LookupSpaces::Color;

    /// The mixes of a run of texels, numbered from 0 in the census. A texel that has no spectrum
    /// counts there and gets that of black. What the run needs that is not known is solved
    /// together, some thousands at a time.
    void locate(std::span<const Color> colors, std::span<Mix> mixes, Scratch& scratch,
                ColorCensus& census);

    /// Notes the nodes that these texels need and nobody has asked for.
    void noteNodes(std::span<const Color> colors);
    void noteAllNodes();
    std::size_t notedCount() const { return lattice_ ? lattice_->store.notedCount() : 0; }
    /// Solves noted nodes until none is left; any number of threads may help.
    void solveNotedNodes();

    std::size_t nodesSolved() const { return lattice_ ? lattice_->store.foundCount() : 0; }

  private:
    static constexpr std::size_t kRun = 64;         ///< its places may stand on the stack
    static constexpr std::size_t kTogether = 2048;  ///< at most so many are solved together

    /// The places of a run in the grid.
    struct Places {
        std::array<Color, kRun> points;
        std::array<std::array<std::uint32_t, 4>, kRun> nodes;
        std::array<std::array<float, 4>, kRun> weights;
        std::array<bool, kRun> inCube;
    };
    void placesOf(std::span<const Color> colors, Places& places) const;
    void locateTogether(std::span<const Color> colors, Mix* mixes, Scratch& scratch,
                        ColorCensus& census);
    void locateRun(std::span<const Color> colors, std::size_t first, Mix* mixes,
                   std::vector<std::size_t>& missing);
    /// A colour's mix; where it is not the grid's alone, with what was solved.
    struct Found {
        Mix mix;
        const SolvedTexel* solved = nullptr;
    };
    std::vector<Found> find(std::span<const Color> colors, Scratch& scratch);
    std::vector<Lattice::Place> placesInGrid(std::span<const Color> colors);
    void findMissing(std::span<const Color> colors, std::span<const std::size_t> missing,
                     Mix* mixes, Scratch& scratch, ColorCensus& census);

    LookupSpaces spaces_;
    std::unique_ptr<Lattice> lattice_;
    TexelSolver texels_;
};

}  // namespace specbake::internal
