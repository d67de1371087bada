#pragma once

#include "upsample/node_values.h"

#include <specbake/core/sampling.h>

#include <array>
#include <cstddef>
#include <span>

namespace specbake::internal {

/// A texel's values as a convex combination of four stored ones: each kNodeStride floats, aligned
/// as NodeValues are.
struct Mix {
    std::array<const float*, 4> values;
    std::array<float, 4> weights;
};

/// One stored spectrum as it is.
inline Mix only(const float* values) {
    return {{values, values, values, values}, {1, 0, 0, 0}};
}

/// Blends a row of texels into `count` planes, the first of kTexelSamples: plane p begins at
/// `planes + p * planeStride` bytes and gets one sample a texel, half (rounded to nearest even) or
/// float. Previews are clamped at 0, bands to [0, 1] (the weights' sum is 1 only to rounding).
/// `planes` and `planeStride` are multiples of a sample's size; nothing but the samples is written.
///
/// A sample is w3 v3 + (w2 v2 + (w1 v1 + w0 v0)), each + with one rounding (fused multiply-add)
/// where the processor has it, as all with AVX2 and all 64-bit Arm do, else with two. So a sample
/// has the same bits on all of these, and everywhere it depends on its texel alone.
void blend(std::span<const Mix> texels, SampleType type, std::byte* planes, std::size_t planeStride,
           std::size_t count = kTexelSamples);

/// The samples that are wanted of each texel, where the target says: the same bits as in blend()
/// for whole bands; between two bands, their mixture with one more rounding.
void blendSome(std::span<const Mix> texels, const SampleSelection& wanted,
               const SampleTarget& target);

}  // namespace specbake::internal
