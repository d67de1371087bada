// Compiled once for each instruction set by foreach_target.h; locate() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "upsample/grid_rows.cpp"
#include "upsample/grid.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
constexpr Floats kFloats;
constexpr Ints kInts;
using Vector = hn::Vec<Floats>;
using IntVector = hn::Vec<Ints>;
constexpr std::size_t kLanes = hn::MaxLanes(kFloats);

/// GridAxis::Place of kLanes coordinates.
struct Places {
    IntVector cell;
    Vector fraction;
};

HWY_INLINE Vector clamped(Vector v) {
    return hn::Min(hn::Max(v, hn::Zero(kFloats)), hn::Set(kFloats, 1.0F));
}

/// The values of `cell` in one of the axis's tables. `Few`: no more cells than lanes, so that a
/// register holds them.
template <bool Few>
HWY_INLINE Vector valuesOf(IntVector cell, std::span<const float> table) {
    static_assert(kLanes <= GridAxis::kShortestTable);
    if constexpr (Few) {
        const Vector all = hn::LoadU(kFloats, table.data());
        return hn::TableLookupLanes(all, hn::IndicesFromVec(kFloats, cell));
    } else {
        return hn::GatherIndex(kFloats, table.data(), cell);
    }
}

/// As GridAxis::locate(), operation by operation.
template <bool Few>
HWY_INLINE Places locate(const GridAxis& axis, Vector coordinate) {
    const Vector u = hn::Mul(hn::Sqrt(clamped(coordinate)), hn::Set(kFloats, axis.cells()));
    IntVector cell = hn::Max(hn::ConvertTo(kInts, u), hn::Zero(kInts));  // NaN, too, has a cell
    cell = hn::Min(cell, hn::Set(kInts, std::int32_t(axis.nodes() - 2)));
    const Vector offset = hn::Sub(coordinate, valuesOf<Few>(cell, axis.positions()));
    return {cell, clamped(hn::Mul(offset, valuesOf<Few>(cell, axis.inverseWidths())))};
}

/// An edge of the cell for each lane: how far along it the point lies, and the step to its node.
struct Edges {
    Vector fraction;
    IntVector stride;
};

/// The edge of the larger fraction first; equal ones stay as they are.
HWY_INLINE void order(Edges& first, Edges& second) {
    const auto swap = hn::Lt(first.fraction, second.fraction);
    const auto swapInts = hn::RebindMask(kInts, swap);
    const Edges a = first;
    first = {hn::IfThenElse(swap, second.fraction, a.fraction),
             hn::IfThenElse(swapInts, second.stride, a.stride)};
    second = {hn::IfThenElse(swap, a.fraction, second.fraction),
              hn::IfThenElse(swapInts, a.stride, second.stride)};
}

HWY_INLINE bool inUnitRange(Vector v) {
    const auto inside = hn::And(hn::Ge(v, hn::Zero(kFloats)), hn::Le(v, hn::Set(kFloats, 1.0F)));
    return hn::AllTrue(kFloats, inside);
}

/// kLanes points, as Grid::locate() does one. Returns whether all lie in the cube.
template <bool Few>
HWY_INLINE bool locateLanes(const GridAxis& axis, const float* points, std::uint32_t* nodes,
                            float* weights) {
    Vector x, y, z;
    hn::LoadInterleaved3(kFloats, points, x, y, z);
    const Places px = locate<Few>(axis, x);
    const Places py = locate<Few>(axis, y);
    const Places pz = locate<Few>(axis, z);
    const IntVector n = hn::Set(kInts, std::int32_t(axis.nodes()));
    Edges first{px.fraction, hn::Mul(n, n)};
    Edges second{py.fraction, n};
    Edges third{pz.fraction, hn::Set(kInts, 1)};
    order(first, second);
    order(second, third);
    order(first, second);

    const IntVector corner = hn::Add(hn::Mul(hn::Add(hn::Mul(px.cell, n), py.cell), n), pz.cell);
    const IntVector node1 = hn::Add(corner, first.stride);
    const IntVector node2 = hn::Add(node1, second.stride);
    const IntVector node3 = hn::Add(node2, third.stride);
    constexpr hn::RebindToUnsigned<Ints> unsignedInts;
    hn::StoreInterleaved4(hn::BitCast(unsignedInts, corner), hn::BitCast(unsignedInts, node1),
                          hn::BitCast(unsignedInts, node2), hn::BitCast(unsignedInts, node3),
                          unsignedInts, nodes);
    hn::StoreInterleaved4(
        hn::Sub(hn::Set(kFloats, 1.0F), first.fraction), hn::Sub(first.fraction, second.fraction),
        hn::Sub(second.fraction, third.fraction), third.fraction, kFloats, weights);
    return inUnitRange(x) && inUnitRange(y) && inUnitRange(z);
}

template <bool Few>
bool locateAll(const GridAxis& axis, std::span<const std::array<float, 3>> points,
               std::array<std::uint32_t, 4>* nodes, std::array<float, 4>* weights) {
    bool inCube = true;
    std::size_t i = 0;
    for (; i + kLanes <= points.size(); i += kLanes) {
        inCube &= locateLanes<Few>(axis, points[i].data(), nodes[i].data(), weights[i].data());
    }
    if (i == points.size()) return inCube;
    std::array<std::array<float, 3>, kLanes> rest{};
    std::array<std::array<std::uint32_t, 4>, kLanes> restNodes;
    std::array<std::array<float, 4>, kLanes> restWeights;
    std::copy(points.begin() + std::ptrdiff_t(i), points.end(), rest.begin());
    inCube &= locateLanes<Few>(axis, rest[0].data(), restNodes[0].data(), restWeights[0].data());
    std::copy_n(restNodes.begin(), points.size() - i, nodes + i);
    std::copy_n(restWeights.begin(), points.size() - i, weights + i);
    return inCube;
}

bool locateRow(const GridAxis& axis, std::span<const std::array<float, 3>> points,
               std::array<std::uint32_t, 4>* nodes, std::array<float, 4>* weights) {
    const bool few = std::size_t(axis.nodes() - 1) <= kLanes;
    return few ? locateAll<true>(axis, points, nodes, weights)
               : locateAll<false>(axis, points, nodes, weights);
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(locateRow);
}  // namespace

bool Grid::locate(std::span<const std::array<float, 3>> points,
                  std::span<std::array<std::uint32_t, 4>> nodes,
                  std::span<std::array<float, 4>> weights) const {
    return HWY_DYNAMIC_DISPATCH(locateRow)(axis_, points, nodes.data(), weights.data());
}

}  // namespace specbake::internal
#endif
