// Compiled once for each instruction set by foreach_target.h; addWeighted() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solve/natural/weighted_sum.cpp"
#include "solve/natural/weighted_sum.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Doubles>;

/// Some bands at a time stay in registers while all terms pass.
void sumOf(std::span<const Weighted> terms, Spectrum& sum) {
    constexpr Doubles doubles;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    constexpr std::size_t last = kBandCount - 1;
    constexpr std::size_t block = 5;
    static_assert(last % (block * lanes) == 0);
    for (std::size_t m = 0; m < last; m += block * lanes) {
        double* to = sum.data() + m;
        Vector a = hn::LoadU(doubles, to);
        Vector b = hn::LoadU(doubles, to + lanes);
        Vector c = hn::LoadU(doubles, to + 2 * lanes);
        Vector d = hn::LoadU(doubles, to + 3 * lanes);
        Vector e = hn::LoadU(doubles, to + 4 * lanes);
        for (const Weighted& term : terms) {
            const Vector weight = hn::Set(doubles, term.weight);
            const double* from = term.spectrum->data() + m;
            const auto product = [&](std::size_t vector) {
                return hn::Mul(weight, hn::LoadU(doubles, from + vector * lanes));
            };
            a = hn::Add(a, product(0));
            b = hn::Add(b, product(1));
            c = hn::Add(c, product(2));
            d = hn::Add(d, product(3));
            e = hn::Add(e, product(4));
        }
        hn::StoreU(a, doubles, to);
        hn::StoreU(b, doubles, to + lanes);
        hn::StoreU(c, doubles, to + 2 * lanes);
        hn::StoreU(d, doubles, to + 3 * lanes);
        hn::StoreU(e, doubles, to + 4 * lanes);
    }
    for (const Weighted& term : terms) sum[last] += term.weight * (*term.spectrum)[last];
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(sumOf);
}  // namespace

void addWeighted(std::span<const Weighted> terms, Spectrum& sum) {
    HWY_DYNAMIC_DISPATCH(sumOf)(terms, sum);
}

}  // namespace specbake::internal
#endif
