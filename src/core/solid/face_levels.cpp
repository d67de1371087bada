// Compiled once for each instruction set by foreach_target.h; FaceLevels chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solid/face_levels.cpp"
#include "solid/face_levels.h"

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathMatrixAlgo.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
constexpr Doubles kDoubles;
using Vector = hn::Vec<Doubles>;
constexpr std::size_t kLanes = hn::MaxLanes(kDoubles);
constexpr std::size_t kBlock = FaceLevels::kBlock;

/// Of a block, its levels or bounds.
struct alignas(64) Levels {
    std::array<double, kBlock> value;
};

/// A direction for all lanes. `Both`: faces on both sides, |n·d|; else n·d.
template <bool Both>
class Direction {
  public:
    explicit Direction(const Imath::V3d& d)
        : x_(hn::Set(kDoubles, d.x)),
          y_(hn::Set(kDoubles, d.y)),
          z_(hn::Set(kDoubles, d.z)),
          size_(hn::Add(hn::Add(hn::Abs(x_), hn::Abs(y_)), hn::Abs(z_))) {}

    HWY_INLINE Vector level(const FaceLevels::Sixteen& n, std::size_t i) const {
        const Vector sum = dot(n, i);
        return Both ? hn::Abs(sum) : sum;
    }
    HWY_INLINE Vector bound(const FaceLevels::Boxes& boxes, std::size_t i) const {
        const Vector doubt = hn::Mul(hn::Load(kDoubles, boxes.rounding.data() + i), size_);
        const Vector first = hn::Add(level(boxes.center, i), hn::Abs(dot(boxes.edges[0], i)));
        const Vector second = hn::Add(doubt, hn::Abs(dot(boxes.edges[1], i)));
        return hn::Add(hn::Add(first, second), hn::Abs(dot(boxes.edges[2], i)));
    }

  private:
    /// Rounded as Imath::V3d::dot() does.
    HWY_INLINE Vector dot(const FaceLevels::Sixteen& v, std::size_t i) const {
        const Vector xy = hn::Add(hn::Mul(hn::Load(kDoubles, v.x.data() + i), x_),
                                  hn::Mul(hn::Load(kDoubles, v.y.data() + i), y_));
        return hn::Add(xy, hn::Mul(hn::Load(kDoubles, v.z.data() + i), z_));
    }

    Vector x_, y_, z_, size_;
};

/// The largest of a block's levels.
template <bool Both>
HWY_INLINE double largestOf(const FaceLevels::Sixteen& leaf, const Direction<Both>& d) {
    Vector largest = d.level(leaf, 0);
    for (std::size_t i = kLanes; i < kBlock; i += kLanes) {
        largest = hn::Max(largest, d.level(leaf, i));
    }
    return hn::GetLane(hn::MaxOfLanes(kDoubles, largest));
}

template <bool Both>
HWY_INLINE Levels boundsOf(const FaceLevels::Boxes& boxes, const Direction<Both>& d) {
    Levels levels;
    for (std::size_t i = 0; i < kBlock; i += kLanes) {
        hn::Store(d.bound(boxes, i), kDoubles, levels.value.data() + i);
    }
    return levels;
}

/// Calls `visit(leaf)` for each leaf whose bound is at least `floor`, which it may raise.
template <bool Both, class Visit>
HWY_INLINE void visitAbove(const FaceLevels::Tree& tree, const Direction<Both>& d,
                           const double& floor, const Visit& visit) {
    for (std::size_t t = 0; t < tree.top.size(); ++t) {
        const Levels top = boundsOf(tree.top[t], d);
        const std::size_t count = std::min(kBlock, tree.boxes.size() - t * kBlock);
        for (std::size_t i = 0; i < count; ++i) {
            if (top.value[i] < floor) continue;
            const std::size_t b = t * kBlock + i;
            const Levels bounds = boundsOf(tree.boxes[b], d);
            const std::size_t leaves = std::min(kBlock, tree.leaves.size() - b * kBlock);
            for (std::size_t k = 0; k < leaves; ++k) {
                if (bounds.value[k] >= floor) visit(b * kBlock + k);
            }
        }
    }
}

std::size_t placeOfLargest(const Levels& levels, std::size_t count) {
    const auto* first = levels.value.data();
    return std::size_t(std::max_element(first, first + std::min(kBlock, count)) - first);
}

/// A leaf that is likely to hold the largest level: that of the largest bounds on the way.
template <bool Both>
std::size_t likelyLeaf(const FaceLevels::Tree& tree, const Direction<Both>& d) {
    std::size_t box = 0;
    double largest = 0;
    for (std::size_t t = 0; t < tree.top.size(); ++t) {
        const Levels top = boundsOf(tree.top[t], d);
        const std::size_t i = placeOfLargest(top, tree.boxes.size() - t * kBlock);
        if (top.value[i] <= largest) continue;
        largest = top.value[i];
        box = t * kBlock + i;
    }
    const Levels bounds = boundsOf(tree.boxes[box], d);
    return box * kBlock + placeOfLargest(bounds, tree.leaves.size() - box * kBlock);
}

template <bool Both>
double largest(const FaceLevels::Tree& tree, const Imath::V3d& direction) {
    if (tree.leaves.empty()) return 0;
    const Direction<Both> d(direction);
    double found = std::max(0.0, largestOf(tree.leaves[likelyLeaf(tree, d)], d));
    visitAbove(tree, d, found,
               [&](std::size_t leaf) { found = std::max(found, largestOf(tree.leaves[leaf], d)); });
    return found;
}

double largestOfBoth(const FaceLevels::Tree& tree, const Imath::V3d& d) {
    return largest<true>(tree, d);
}

double largestOfOne(const FaceLevels::Tree& tree, const Imath::V3d& d) {
    return largest<false>(tree, d);
}

/// The places in the leaves, in the order of these, of the levels that reach the threshold.
std::vector<std::size_t> placesAtLeast(const FaceLevels::Tree& tree, double threshold,
                                       const Imath::V3d& direction) {
    const Direction<true> d(direction);
    std::vector<std::size_t> places;
    visitAbove(tree, d, threshold, [&](std::size_t leaf) {
        Levels levels;
        for (std::size_t i = 0; i < kBlock; i += kLanes) {
            hn::Store(d.level(tree.leaves[leaf], i), kDoubles, levels.value.data() + i);
        }
        for (std::size_t i = 0; i < kBlock; ++i) {
            if (levels.value[i] >= threshold) places.push_back(leaf * kBlock + i);
        }
    });
    return places;
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {

HWY_EXPORT(largestOfBoth);
HWY_EXPORT(largestOfOne);
HWY_EXPORT(placesAtLeast);

/// The principal axes of some vectors: the rows.
Imath::M33d principalAxes(std::span<const Imath::V3d> vectors) {
    Imath::V3d mean(0.0);
    for (const Imath::V3d& v : vectors) mean += v / double(vectors.size());
    Imath::M33d spread(0.0);
    for (const Imath::V3d& v : vectors) {
        const Imath::V3d d = v - mean;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) spread[i][j] += d[i] * d[j];
        }
    }
    Imath::V3d values;
    Imath::M33d axes;
    Imath::jacobiEigenSolver(spread, values, axes);
    return axes.transposed();
}

std::span<const std::uint32_t> part(std::span<const std::uint32_t> all, std::size_t i,
                                    std::size_t size) {
    return all.subspan(i * size, std::min(size, all.size() - i * size));
}

}  // namespace

FaceLevels::FaceLevels(const std::vector<Imath::V3d>& normals)
    : normals_(normals), order_(normals.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    arrange(order_);
    tree_.leaves.resize((order_.size() + kBlock - 1) / kBlock);
    for (std::size_t i = 0; i < order_.size(); ++i) {
        tree_.leaves[i / kBlock].set(i % kBlock, normals_[order_[i]]);
    }
    for (std::size_t i = 0; i < tree_.leaves.size(); ++i) {
        addBox(part(order_, i, kBlock), i, tree_.boxes);
    }
    for (std::size_t i = 0; i < tree_.boxes.size(); ++i) {
        addBox(part(order_, i, kBlock * kBlock), i, tree_.top);
    }
}

/// The i-th of `boxes`, around the normals of a block.
void FaceLevels::addBox(std::span<const std::uint32_t> block, std::size_t i,
                        std::vector<Boxes>& boxes) const {
    // Axes, coordinates and edges, a bound and a level: each takes less than a dozen roundings.
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    std::vector<Imath::V3d> normals;
    for (const std::uint32_t n : block) normals.push_back(normals_[n]);
    const Imath::M33d axes = principalAxes(normals);
    Imath::Box3d box;  // along the axes
    for (const Imath::V3d& n : normals) box.extendBy(n * axes.transposed());
    if (i % kBlock == 0) boxes.emplace_back();
    Boxes& sixteen = boxes.back();
    const Imath::V3d half = box.size() / 2;
    sixteen.center.set(i % kBlock, box.center() * axes);
    for (int k = 0; k < 3; ++k) {
        const Imath::V3d axis(axes[k][0], axes[k][1], axes[k][2]);
        sixteen.edges[std::size_t(k)].set(i % kBlock, half[k] * axis);
    }
    sixteen.rounding[i % kBlock] = rounding * (box.center().length() + half.length());
}

/// Halves along the longest axis, at the borders of blocks.
void FaceLevels::arrange(std::span<std::uint32_t> order) const {
    const std::size_t whole = order.size() > kBlock * kBlock ? kBlock * kBlock : kBlock;
    if (order.size() <= kBlock) return;
    Imath::Box3d box;
    for (const std::uint32_t i : order) box.extendBy(normals_[i]);
    const int axis = int(box.majorAxis());
    const std::size_t half = std::max(whole, order.size() / 2 / whole * whole);
    std::nth_element(
        order.begin(), order.begin() + std::ptrdiff_t(half), order.end(),
        [&](std::uint32_t a, std::uint32_t b) { return normals_[a][axis] < normals_[b][axis]; });
    arrange(order.first(half));
    arrange(order.subspan(half));
}

double FaceLevels::largest(const Imath::V3d& d) const {
    return HWY_DYNAMIC_DISPATCH(largestOfBoth)(tree_, d);
}

double FaceLevels::largestAbove(const Imath::V3d& d) const {
    return HWY_DYNAMIC_DISPATCH(largestOfOne)(tree_, d);
}

std::vector<std::size_t> FaceLevels::atLeast(double threshold, const Imath::V3d& d) const {
    std::vector<std::size_t> found = HWY_DYNAMIC_DISPATCH(placesAtLeast)(tree_, threshold, d);
    std::erase_if(found, [this](std::size_t place) { return place >= order_.size(); });
    for (std::size_t& place : found) place = order_[place];
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace specbake::internal
#endif
