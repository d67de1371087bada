#pragma once

#include <specbake/core/upsampler_options.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace specbake::internal {

/// Node positions along one axis of the grid: u² for u = 0, 1/(n-1), …, 1, dense in the dark as
/// the eye is. Positions are floats, so that a colour that was stored as one meets them exactly.
class GridAxis {
  public:
    /// Throws ArgumentError unless kFewestGridNodes <= nodes <= kMostGridNodes.
    explicit GridAxis(int nodes);

    int nodes() const { return nodes_; }
    float cells() const { return float(nodes_ - 1); }
    float position(int node) const { return position_[std::size_t(node)]; }

    /// Tables have kShortestTable values at least, so that registers load them whole; those beyond
    /// the axis are 0.
    static constexpr std::size_t kShortestTable = 16;
    std::span<const float> positions() const { return position_; }
    /// 1 / (position(i + 1) - position(i)) of cell i.
    std::span<const float> inverseWidths() const { return inverseWidth_; }

    struct Place {
        int cell;        ///< the cell between nodes `cell` and `cell + 1`
        float fraction;  ///< in [0, 1]
    };
    /// Where a coordinate lies; 0 <= coordinate <= 1 (others go to the nearest end).
    Place locate(float coordinate) const;

  private:
    int nodes_;
    std::vector<float> position_;
    std::vector<float> inverseWidth_;
};

/// A point of the unit cube as a convex combination of four nodes: the corners of one of the six
/// tetrahedra into which H. W. Kuhn (1960) splits a cell, along its diagonal. Weights are the
/// point's barycentric weights: >= 0, and their sum is 1 to rounding.
struct GridSimplex {
    std::array<std::uint32_t, 4> node;
    std::array<float, 4> weight;
};

/// The lookup grid over the unit cube of a linear colour space: index mapping and interpolation.
/// It holds no spectra and knows no solver; nodes are numbered, and what stands at a node is its
/// owner's (node_store.h).
///
/// Since (1) is linear and (2) convex, the four nodes' spectra blended by these weights have the
/// point's colour exactly and stay within [0, 1], whatever the resolution.
class Grid {
  public:
    explicit Grid(int nodesPerAxis) : axis_(nodesPerAxis) {}

    const GridAxis& axis() const { return axis_; }
    std::size_t nodeCount() const;

    /// The tetrahedron of a point; each coordinate in [0, 1].
    GridSimplex locate(const std::array<float, 3>& point) const;
    /// The same for many points, much faster: the same bits. Returns whether all lie in the cube;
    /// coordinates outside [0, 1] are clamped, NaN gives any tetrahedron.
    bool locate(std::span<const std::array<float, 3>> points,
                std::span<std::array<std::uint32_t, 4>> nodes,
                std::span<std::array<float, 4>> weights) const;

    /// The position of a node.
    std::array<float, 3> position(std::uint32_t node) const;

    /// The number of the node at (i, j, k).
    std::uint32_t node(int i, int j, int k) const;

  private:
    GridAxis axis_;
};

}  // namespace specbake::internal
