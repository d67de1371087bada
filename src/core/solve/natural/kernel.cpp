// Compiled once for each instruction set by foreach_target.h; weighNear() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solve/natural/kernel.cpp"
#include "solve/natural/kernel.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#ifdef HWY_TARGET  // after foreach_target.h only: once for each instruction set
#include <hwy/contrib/math/math-inl.h>
#endif

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Integers = hn::RebindToUnsigned<Doubles>;
using Vector = hn::Vec<Doubles>;

/// What is stored of near ones; some lanes behind them may be written over.
std::size_t weighAll(const Places& places, const Imath::V3d& p, double farthest, double factor,
                     std::uint64_t* indices, double* weights) {
    constexpr Doubles doubles;
    constexpr Integers integers;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto squared = [&](const std::vector<double>& coordinates, std::size_t k, double of) {
        const Vector d = hn::Sub(hn::Set(doubles, of), hn::LoadU(doubles, coordinates.data() + k));
        return hn::Mul(d, d);
    };
    std::size_t count = 0;
    for (std::size_t k = 0; k < places.x.size(); k += lanes) {
        const Vector xy = hn::Add(squared(places.x, k, p.x), squared(places.y, k, p.y));
        const Vector distance = hn::Add(xy, squared(places.z, k, p.z));
        const auto near = hn::Le(distance, hn::Set(doubles, farthest));
        if (hn::AllFalse(doubles, near)) continue;
        // Where it is far, the distance may be infinite.
        const Vector held = hn::Min(distance, hn::Set(doubles, farthest));
        const Vector weight = hn::Exp(doubles, hn::Mul(hn::Set(doubles, factor), held));
        hn::CompressStore(weight, near, doubles, weights + count);
        const auto at = hn::Iota(integers, std::uint64_t(k));
        count += hn::CompressStore(at, hn::RebindMask(integers, near), integers, indices + count);
    }
    return count;
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {

HWY_EXPORT(weighAll);

constexpr std::size_t kMostLanes = 8;

}  // namespace

void Places::add(const Imath::V3d& place) {
    if (x.size() == count) {
        constexpr double far = std::numeric_limits<double>::infinity();
        for (auto* coordinates : {&x, &y, &z}) coordinates->resize(count + kMostLanes, far);
    }
    x[count] = place.x;
    y[count] = place.y;
    z[count] = place.z;
    ++count;
}

void weighNear(const Places& places, const Imath::V3d& p, double h, Near& near) {
    constexpr double negligible = 0x1p-40;
    const double factor = -1 / (2 * h * h);
    const double farthest = std::log(negligible) / factor;
    const std::size_t room = std::max(near.weightRoom.size(), places.x.size() + kMostLanes);
    near.indexRoom.resize(room);
    near.weightRoom.resize(room);
    const std::size_t count = HWY_DYNAMIC_DISPATCH(weighAll)(
        places, p, farthest, factor, near.indexRoom.data(), near.weightRoom.data());
    near.indices = std::span(near.indexRoom).first(count);
    near.weights = std::span(near.weightRoom).first(count);
}

}  // namespace specbake::internal
#endif
