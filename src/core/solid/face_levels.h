#pragma once

#include <Imath/ImathVec.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace specbake::internal {

/// The largest n·d, or |n·d|, of some thousands of normals n, without looking at all of them.
///
/// Normals that are near to each other form blocks of sixteen, and near blocks form blocks again.
/// Of each block a box around its normals is kept that lies along their principal axes, since they
/// are on a thin curved sheet: with the centre m and the half edges v_k,
///
///     n·d <= m·d + Σ |v_k·d|,   |n·d| <= |m·d| + Σ |v_k·d|   for all n of the block,
///
/// and a block whose bound is below what was found already is passed over. The result is the same
/// number that looking at all would give, to the bit, on every processor.
class FaceLevels {
  public:
    FaceLevels() = default;
    explicit FaceLevels(const std::vector<Imath::V3d>& normals);

    /// max |n·d|, at least 0.
    double largest(const Imath::V3d& d) const;

    /// max n·d, at least 0.
    double largestAbove(const Imath::V3d& d) const;

    /// The indices with |n·d| >= threshold, ascending.
    std::vector<std::size_t> atLeast(double threshold, const Imath::V3d& d) const;

    /// n·d
    double level(std::size_t index, const Imath::V3d& d) const { return normals_[index].dot(d); }

    static constexpr std::size_t kBlock = 16;

    /// The components of sixteen vectors; those that a block has too few of are 0.
    struct alignas(64) Sixteen {
        std::array<double, kBlock> x{}, y{}, z{};

        void set(std::size_t i, const Imath::V3d& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
        Imath::V3d at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    };
    /// The boxes around sixteen blocks.
    struct Boxes {
        Sixteen center;
        std::array<Sixteen, 3> edges;  ///< half of each
        /// What roundings can add to a bound, over |d_x| + |d_y| + |d_z|.
        alignas(64) std::array<double, kBlock> rounding{};
    };
    /// The blocks, as a tree of three storeys.
    struct Tree {
        std::vector<Sixteen> leaves;  ///< normals
        std::vector<Boxes> boxes;     ///< around sixteen leaves each
        std::vector<Boxes> top;       ///< around what sixteen of `boxes` hold
    };

  private:
    void addBox(std::span<const std::uint32_t> block, std::size_t i,
                std::vector<Boxes>& boxes) const;
    void arrange(std::span<std::uint32_t> order) const;

    std::vector<Imath::V3d> normals_;
    std::vector<std::uint32_t> order_;  ///< the indices as they stand in the leaves
    Tree tree_;
};

}  // namespace specbake::internal
