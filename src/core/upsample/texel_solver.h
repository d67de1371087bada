#pragma once

#include "upsample/lattice.h"
#include "upsample/lookup_spaces.h"
#include "upsample/spectrum_cache.h"

#include <cstddef>
#include <span>
#include <vector>

namespace specbake::internal {

/// Solves texels by themselves, many at once, and remembers them. Just outside the grid's cube, the
/// difference between what the grid gives and what is solved fades out, so that there is no step at
/// the cube's faces (M12). Any number of threads may share it.
class TexelSolver {
  public:
    using Color = LookupSpaces::Color;

    /// `lattice`: nullptr where there is no grid. All must outlive it.
    TexelSolver(const LookupSpaces& spaces, const ColorResolver& resolver,
                const NodeEncoder& encoder, Lattice* lattice)
        : spaces_(spaces), resolver_(resolver), lattice_(lattice), encoder_(encoder) {}

    /// Solves `colors[i]` into `texels[i]`: as many of the one as of the other.
    void solve(std::span<const Color> colors, std::span<SolvedTexel> texels);

  private:
    /// A texel near a face of the cube, and the point of the cube nearest to it.
    struct FaceStep {
        std::size_t texel = 0;
        Color onFace{};
        float share = 1;  ///< of the difference, by the distance alone
        Lattice::Place place;
    };

    std::vector<SolvedTexel> solveAnew(std::span<const Color> colors);
    std::vector<FaceStep> faceSteps(std::span<const Color> colors);
    std::vector<SolvedTexel> solveColors(std::span<const XYZ> asked) const;
    SolvedTexel texelOf(const XYZ& asked, const ColorResolver::Resolved& resolved) const;

    const LookupSpaces& spaces_;
    const ColorResolver& resolver_;
    Lattice* lattice_;
    NodeEncoder encoder_;
    SpectrumCache cache_;
};

}  // namespace specbake::internal
