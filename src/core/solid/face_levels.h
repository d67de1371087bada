#pragma once

#include <Imath/ImathVec.h>

#include <array>
#include <cstddef>
#include <vector>

namespace specbake::internal {

/// The largest |n·d| of some thousands of normals n, without looking at all of them.
///
/// Normals come in an order in which neighbours are alike (the faces that share a generator). Of
/// each block of kBlock the box around its normals is kept, centre m and half sizes e, so that
///
///     |n·d| <= |m·d| + e·|d|   for all n of the block,
///
/// and a block whose bound is below what was found already is passed over. The result is the same
/// number that looking at all would give.
class FaceLevels {
  public:
    FaceLevels() = default;
    explicit FaceLevels(const std::vector<Imath::V3d>& normals);

    /// max |n·d|, at least 0.
    double largest(const Imath::V3d& d) const;

    /// The indices with |n·d| >= threshold, ascending.
    std::vector<std::size_t> atLeast(double threshold, const Imath::V3d& d) const;

    /// n·d
    double level(std::size_t index, const Imath::V3d& d) const { return normals_[index].dot(d); }

  private:
    static constexpr std::size_t kBlock = 16;
    struct Box {
        Imath::V3d center, half;
    };

    double largestOfBlock(std::size_t block, const Imath::V3d& d) const;

    std::vector<Imath::V3d> normals_;  ///< padded with zeros to whole blocks
    std::vector<Box> boxes_;
};

}  // namespace specbake::internal
