#pragma once

#include "table/node_spectra.h"

namespace specbake::internal {

/// What a node beyond the solid may hold at most: samples have 16 bits for all of the range.
inline constexpr double kLowestValue = -0.25;
inline constexpr double kHighestValue = 1.25;

/// Chooses the spectra of the nodes that the solid does not hold so that blends with them stay
/// within [0, 1] where the colour is one that a reflectance can have.
///
/// A blend has its colour exactly, whatever stands at the nodes, as long as each node has its own.
/// What a reader clamps is what changes the colour. So: minimise, over colours of the solid in the
/// cells that its boundary cuts, the sum of the squares of what leaves [0, 1] in any band; each
/// node that such a colour needs has its own colour, and values in the range above. The problem is
/// convex; it is solved by an accelerated projected gradient (Y. Nesterov 1983) that begins with
/// the spectra of the nearest colours, corrected to the nodes' own.
void extendBeyondSolid(const Grid& grid, const Upsampler& upsampler, NodeSpectra& nodes);

}  // namespace specbake::internal
