// Compiled once for each instruction set by foreach_target.h; blend() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "upsample/blend.cpp"
#include "upsample/blend.h"

#include <Imath/half.h>
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kBlock = 64;  ///< texels that go to their planes together
using Floats = hn::CappedTag<float, 16>;
constexpr Floats kFloats;
using Vector = hn::Vec<Floats>;
constexpr std::size_t kLanes = hn::MaxLanes(kFloats);

constexpr std::array<float, kNodeStride> mostOfEachValue() {
    std::array<float, kNodeStride> most{};
    most.fill(1);
    for (std::size_t p = 0; p < kPreviewSamples; ++p) most[p] = std::numeric_limits<float>::max();
    return most;
}
alignas(64) constexpr std::array<float, kNodeStride> kMost = mostOfEachValue();

/// A row of texels in at most kTexelSamples planes on its way to memory. Blocks of kBlock texels
/// are put together here and leave by whole cache lines past the caches: written in place, the
/// planes, often a power of two apart, would drive each other out of the cache.
template <class Sample>
class PlaneRows {
  public:
    PlaneRows(std::byte* planes, std::size_t stride, std::size_t count)
        : planes_(planes), stride_(stride), count_(count) {}

    /// Where the samples of the block at hand go.
    Sample* block(std::size_t plane) { return line_[plane].data() + kLine; }

    /// Sends a whole block, which begins at texel `first`; what does not fill a line waits.
    void send(std::size_t first) {
        for (std::size_t p = 0; p < count_; ++p) {
            Sample* to = row(p) + first;
            const std::size_t waiting = waitingBefore(to);
            const Sample* from = block(p) - waiting;
            std::size_t at = 0;
            if (first == 0 && waiting > 0) {  // what stands before the row is not ours
                std::copy_n(block(p), kLine - waiting, to);
                at = kLine;
            }
            for (; at < kBlock; at += kLine) stream(from + at, to - waiting + at);
            if (waiting > 0) std::copy_n(block(p) + kBlock - kLine, kLine, line_[p].data());
        }
    }

    /// Sends what waits, and `count` samples of the block at hand.
    void finish(std::size_t first, std::size_t count) {
        for (std::size_t p = 0; p < count_; ++p) {
            Sample* to = row(p) + first;
            const std::size_t waiting = first == 0 ? 0 : waitingBefore(to);
            std::copy_n(block(p) - waiting, waiting + count, to - waiting);
        }
    }

  private:
    static constexpr std::size_t kLineBytes = 64;
    static constexpr std::size_t kLine = kLineBytes / sizeof(Sample);

    Sample* row(std::size_t plane) const {
        return reinterpret_cast<Sample*>(planes_ + plane * stride_);
    }
    /// Samples between the beginning of the line and this one.
    static std::size_t waitingBefore(const Sample* sample) {
        return reinterpret_cast<std::uintptr_t>(sample) % kLineBytes / sizeof(Sample);
    }
    static void stream(const Sample* from, Sample* to) {
        constexpr hn::CappedTag<std::uint8_t, kLineBytes> bytes;
        const auto* source = reinterpret_cast<const std::uint8_t*>(from);
        auto* target = reinterpret_cast<std::uint8_t*>(to);
        for (std::size_t i = 0; i < kLineBytes; i += hn::MaxLanes(bytes)) {
            hn::Stream(hn::LoadU(bytes, source + i), bytes, target + i);
        }
    }

    std::byte* planes_;
    std::size_t stride_;
    std::size_t count_;  ///< of the planes; what is beyond is blended, and goes nowhere
    /// Of each plane, the line before the block and the block.
    alignas(kLineBytes) std::array<std::array<Sample, kLine + kBlock>, kTexelSamples> line_;
};

/// Four values of kLanes texels: value by value, a lane a texel.
struct Columns {
    Vector c0, c1, c2, c3;
};

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Columns transposed(const float* row, std::size_t /*stride*/) {
    const auto at = [row](std::size_t i) { return hn::Load(kFloats, row + i); };
    return {at(0), at(1), at(2), at(3)};
}
#else
/// Blocks of 4 floats at `first`, `first + 4 * stride`, …, as one vector.
template <class D>
HWY_INLINE hn::Vec<D> everyFourthRow(D d, const float* first, std::size_t stride) {
    constexpr std::size_t lanes = hn::MaxLanes(D());
    if constexpr (lanes <= 4) {
        return hn::Load(d, first);
    } else {
        const hn::Half<D> half;
        return hn::Combine(d, everyFourthRow(half, first + lanes / 2 * stride, stride),
                           everyFourthRow(half, first, stride));
    }
}

/// Transposes kLanes rows of 4 floats, `stride` floats apart and aligned to 16 bytes.
HWY_INLINE Columns transposed(const float* rows, std::size_t stride) {
    const Vector r0 = everyFourthRow(kFloats, rows, stride);
    const Vector r1 = everyFourthRow(kFloats, rows + stride, stride);
    const Vector r2 = everyFourthRow(kFloats, rows + 2 * stride, stride);
    const Vector r3 = everyFourthRow(kFloats, rows + 3 * stride, stride);
    const Vector low02 = hn::InterleaveLower(kFloats, r0, r2);
    const Vector low13 = hn::InterleaveLower(kFloats, r1, r3);
    const Vector high02 = hn::InterleaveUpper(kFloats, r0, r2);
    const Vector high13 = hn::InterleaveUpper(kFloats, r1, r3);
    return {hn::InterleaveLower(kFloats, low02, low13), hn::InterleaveUpper(kFloats, low02, low13),
            hn::InterleaveLower(kFloats, high02, high13),
            hn::InterleaveUpper(kFloats, high02, high13)};
}

#endif

/// The one formula of a sample; Columns hold weights or values of different texels.
HWY_INLINE Vector weightedSum(const Columns& w, const Columns& v) {
    const Vector first = hn::MulAdd(w.c1, v.c1, hn::Mul(w.c0, v.c0));
    return hn::MulAdd(w.c3, v.c3, hn::MulAdd(w.c2, v.c2, first));
}

HWY_INLINE Vector clamped(Vector samples, Vector most) {
    return hn::Min(hn::Max(samples, hn::Zero(kFloats)), most);
}

HWY_INLINE void store(Vector samples, float* to) {
    hn::StoreU(samples, kFloats, to);
}

HWY_INLINE void store(Vector samples, Imath::half* to) {
#if (HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2) || (HWY_ARCH_ARM_A64 && HWY_TARGET == HWY_NEON)
    const hn::Rebind<hwy::float16_t, Floats> halves;
    hn::StoreU(hn::DemoteTo(halves, samples), halves, reinterpret_cast<hwy::float16_t*>(to));
#else  // Highway's own conversion truncates where the processor has none
    alignas(64) std::array<float, kLanes> lanes;
    hn::Store(samples, kFloats, lanes.data());
    std::transform(lanes.begin(), lanes.end(), to, [](float v) { return Imath::half(v); });
#endif
}

/// kLanes texels between the same four spectra: a plane at a time, no transposition.
template <class Sample>
void blendTogether(const Mix* texels, PlaneRows<Sample>& rows, std::size_t at) {
    static_assert(sizeof(Mix) % sizeof(float) == 0);
    const Columns w = transposed(texels->weights.data(), sizeof(Mix) / sizeof(float));
    const auto& v = texels->values;
    for (std::size_t p = 0; p < kTexelSamples; ++p) {
        const Columns same = {hn::Set(kFloats, v[0][p]), hn::Set(kFloats, v[1][p]),
                              hn::Set(kFloats, v[2][p]), hn::Set(kFloats, v[3][p])};
        const Vector most = hn::Set(kFloats, kMost[p]);
        store(clamped(weightedSum(w, same), most), rows.block(p) + at);
    }
}

HWY_INLINE void prefetch(const Mix& texel) {
    for (const float* values : texel.values) {
        for (std::size_t p = 0; p < kTexelSamples; p += 16) hwy::Prefetch(values + p);
    }
}

/// One texel's samples, side by side.
void blendOne(const Mix& texel, float* samples) {
    const auto& [v, weight] = texel;
    const Columns w = {hn::Set(kFloats, weight[0]), hn::Set(kFloats, weight[1]),
                       hn::Set(kFloats, weight[2]), hn::Set(kFloats, weight[3])};
    for (std::size_t p = 0; p < kTexelSamples; p += kLanes) {
        const Columns values = {hn::Load(kFloats, v[0] + p), hn::Load(kFloats, v[1] + p),
                                hn::Load(kFloats, v[2] + p), hn::Load(kFloats, v[3] + p)};
        const Vector most = hn::Load(kFloats, kMost.data() + p);
        hn::Store(clamped(weightedSum(w, values), most), kFloats, samples + p);
    }
}

/// kLanes texels of any spectra: texel by texel, then transposed into the planes.
template <class Sample>
void blendApart(const Mix* texels, PlaneRows<Sample>& rows, std::size_t at) {
    alignas(64) std::array<std::array<float, kNodeStride>, kLanes> samples;
    for (std::size_t i = 0; i < kLanes; ++i) {
        prefetch(texels[std::min(i + 3, kLanes - 1)]);  // three texels take as long as a cache miss
        blendOne(texels[i], samples[i].data());
    }
    for (std::size_t p = 0; p < kTexelSamples; p += 4) {
        const Columns c = transposed(samples[0].data() + p, kNodeStride);
        store(c.c0, rows.block(p) + at);
        store(c.c1, rows.block(p + 1) + at);
        store(c.c2, rows.block(p + 2) + at);
        store(c.c3, rows.block(p + 3) + at);
    }
}

bool sameSpectra(const Mix* texels) {
    bool same = true;
    for (std::size_t i = 1; i < kLanes; ++i) {
        for (std::size_t k = 0; k < 4; ++k) same &= texels[i].values[k] == texels[0].values[k];
    }
    return same;
}

template <class Sample>
void blendBlock(const Mix* texels, PlaneRows<Sample>& rows) {
    for (std::size_t at = 0; at < kBlock; at += kLanes) {
        sameSpectra(texels + at) ? blendTogether(texels + at, rows, at)
                                 : blendApart(texels + at, rows, at);
    }
}

template <class Sample>
void blendRow(std::span<const Mix> texels, std::byte* planes, std::size_t planeStride,
              std::size_t count) {
    PlaneRows<Sample> rows(planes, planeStride, count);
    std::size_t first = 0;
    for (; first + kBlock <= texels.size(); first += kBlock) {
        blendBlock(texels.data() + first, rows);
        rows.send(first);
    }
    const std::span<const Mix> rest = texels.subspan(first);
    if (!rest.empty()) {
        std::array<Mix, kBlock> padded;
        padded.fill(rest.back());
        std::copy(rest.begin(), rest.end(), padded.begin());
        blendBlock(padded.data(), rows);
    }
    rows.finish(first, rest.size());
    hwy::FlushStream();
}

/// One texel's samples that are wanted, of all of them.
template <class Sample>
void storeSome(const float* samples, const SampleSelection& wanted, std::byte* to,
               std::size_t step) {
    if (wanted.run() && step == sizeof(Sample)) {
        alignas(64) std::array<Sample, kNodeStride> stored;
        for (std::size_t p = 0; p < kTexelSamples; p += kLanes) {
            store(hn::Load(kFloats, samples + p), stored.data() + p);
        }
        std::memcpy(to, stored.data() + *wanted.run(), wanted.count() * sizeof(Sample));
        return;
    }
    for (const auto& [first, fraction] : wanted.taps()) {
        const float low = samples[first];
        const Sample sample(fraction == 0 ? low : low + fraction * (samples[first + 1] - low));
        std::memcpy(to, &sample, sizeof sample);
        to += step;
    }
}

void blendWanted(std::span<const Mix> texels, const SampleSelection& wanted,
                 const SampleTarget& target) {
    alignas(64) std::array<float, kNodeStride> samples;
    std::byte* to = target.to;
    for (const Mix& texel : texels) {
        blendOne(texel, samples.data());
        target.type == SampleType::half
            ? storeSome<Imath::half>(samples.data(), wanted, to, target.perSample)
            : storeSome<float>(samples.data(), wanted, to, target.perSample);
        to += target.perColor;
    }
}

void blendHalf(std::span<const Mix> texels, std::byte* planes, std::size_t planeStride,
               std::size_t count) {
    blendRow<Imath::half>(texels, planes, planeStride, count);
}

void blendFloat(std::span<const Mix> texels, std::byte* planes, std::size_t planeStride,
                std::size_t count) {
    blendRow<float>(texels, planes, planeStride, count);
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(blendHalf);
HWY_EXPORT(blendFloat);
HWY_EXPORT(blendWanted);
}  // namespace

void blend(std::span<const Mix> texels, SampleType type, std::byte* planes, std::size_t planeStride,
           std::size_t count) {
    if (type == SampleType::half) {
        HWY_DYNAMIC_DISPATCH(blendHalf)(texels, planes, planeStride, count);
    } else {
        HWY_DYNAMIC_DISPATCH(blendFloat)(texels, planes, planeStride, count);
    }
}

void blendSome(std::span<const Mix> texels, const SampleSelection& wanted,
               const SampleTarget& target) {
    HWY_DYNAMIC_DISPATCH(blendWanted)(texels, wanted, target);
}

}  // namespace specbake::internal
#endif
