// Compiled once for each instruction set by foreach_target.h; splitAndPredict() chooses at run
// time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spectral/pack/zip_predictor.cpp"
#include "spectral/pack/zip_predictor.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<std::uint8_t, 64> kBytes;
using Vector = hn::Vec<decltype(kBytes)>;
constexpr std::size_t kLanes = hn::MaxLanes(kBytes);

HWY_INLINE Vector difference(Vector to, Vector from) {
    return hn::Add(hn::Sub(to, from), hn::Set(kBytes, 128));
}

void predict(std::span<const std::uint8_t> samples, std::uint8_t* predicted) {
    if (samples.empty()) return;
    const std::size_t odds = samples.size() / 2;
    const std::size_t evens = samples.size() - odds;
    const std::uint8_t* const from = samples.data();
    std::uint8_t* const even = predicted;
    std::uint8_t* const odd = predicted + evens;
    even[0] = from[0];
    if (odds > 0) odd[0] = std::uint8_t(from[1] - from[2 * evens - 2] + 128);
    std::size_t i = 1;
    for (; i + kLanes <= odds; i += kLanes) {
        Vector evenNow, oddNow, evenBefore, oddBefore;
        hn::LoadInterleaved2(kBytes, from + 2 * i, evenNow, oddNow);
        hn::LoadInterleaved2(kBytes, from + 2 * i - 2, evenBefore, oddBefore);
        hn::StoreU(difference(evenNow, evenBefore), kBytes, even + i);
        hn::StoreU(difference(oddNow, oddBefore), kBytes, odd + i);
    }
    for (; i < evens; ++i) {
        even[i] = std::uint8_t(from[2 * i] - from[2 * i - 2] + 128);
        if (i < odds) odd[i] = std::uint8_t(from[2 * i + 1] - from[2 * i - 1] + 128);
    }
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(predict);
}  // namespace

void splitAndPredict(std::span<const std::uint8_t> samples, std::span<std::uint8_t> predicted) {
    HWY_DYNAMIC_DISPATCH(predict)(samples, predicted.data());
}

void restore(std::span<const std::uint8_t> predicted, std::span<std::uint8_t> samples) {
    const std::size_t even = (samples.size() + 1) / 2;
    std::uint8_t last = 128;
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        last = std::uint8_t(last + predicted[i] - 128);
        samples[i < even ? 2 * i : 2 * (i - even) + 1] = last;
    }
}

}  // namespace specbake::internal
#endif
