// Compiled once for each instruction set by foreach_target.h; fastest() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solid/release_rates.cpp"
#include "solid/release_rates.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
constexpr Doubles kDoubles;
using Vector = hn::Vec<Doubles>;
constexpr std::size_t kLanes = hn::MaxLanes(kDoubles);

/// v·w of kLanes generators; each product and sum is rounded.
struct Direction {
    explicit Direction(const Imath::V3d& v)
        : x(hn::Set(kDoubles, v.x)), y(hn::Set(kDoubles, v.y)), z(hn::Set(kDoubles, v.z)) {}

    HWY_INLINE Vector dot(const ReleaseRates::Table& w, std::size_t j) const {
        const Vector xy = hn::Add(hn::Mul(hn::Load(kDoubles, w.x.data() + j), x),
                                  hn::Mul(hn::Load(kDoubles, w.y.data() + j), y));
        return hn::Add(xy, hn::Mul(hn::Load(kDoubles, w.z.data() + j), z));
    }

    Vector x, y, z;
};

std::size_t fastestOf(const ReleaseRates::Table& w, const ReleaseRates::Sides& sides,
                      const Imath::V3d& gap, const Imath::V3d& rounding) {
    const Direction along(gap);
    const Direction doubt(rounding);
    const Vector zero = hn::Zero(kDoubles);
    Vector greatest = zero;
    Vector winner = zero;
    Vector number = hn::Iota(kDoubles, 0);
    for (std::size_t j = 0; j < ReleaseRates::kSlots; j += kLanes) {
        const Vector slope = hn::Mul(hn::Load(kDoubles, sides.value.data() + j), along.dot(w, j));
        const auto beyondDoubt = hn::Gt(slope, doubt.dot(w, j));
        const Vector rate =
            hn::Mul(hn::Mul(slope, slope), hn::Load(kDoubles, w.inverse.data() + j));
        const auto better = hn::And(beyondDoubt, hn::Gt(rate, greatest));
        greatest = hn::IfThenElse(better, rate, greatest);
        winner = hn::IfThenElse(better, number, winner);
        number = hn::Add(number, hn::Set(kDoubles, double(kLanes)));
    }
    const Vector most = hn::MaxOfLanes(kDoubles, greatest);
    if (hn::GetLane(most) == 0) return ReleaseRates::kNone;
    // Of lanes that tie, the first generator: so it is for any number of lanes.
    const Vector none = hn::Set(kDoubles, double(ReleaseRates::kNone));
    const Vector tied = hn::IfThenElse(hn::Eq(greatest, most), winner, none);
    return std::size_t(hn::GetLane(hn::MinOfLanes(kDoubles, tied)));
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(fastestOf);
}  // namespace

ReleaseRates::ReleaseRates(std::span<const Imath::V3d> vectors) {
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        const Imath::V3d& w = vectors[j];
        table_.x[j] = w.x;
        table_.y[j] = w.y;
        table_.z[j] = w.z;
        table_.inverse[j] = w.length2() > 0 ? 1 / w.length2() : 0;
    }
}

std::size_t ReleaseRates::fastest(const Sides& sides, const Imath::V3d& gap,
                                  const Imath::V3d& rounding) const {
    return HWY_DYNAMIC_DISPATCH(fastestOf)(table_, sides, gap, rounding);
}

}  // namespace specbake::internal
#endif
