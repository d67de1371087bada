#pragma once

#include "texel_source.h"

#include <specbake/bake/model_cache.h>

namespace specbake::internal {

/// The coarsest grid whose spectra deviate from the directly solved ones by at most `deviation`:
/// RMS over the bands and all texels, or over those of a sample of kMostColors of the texture's
/// colours where it has more.
struct GridChoice {
    int nodes = 0;
    double deviation = 0;    ///< what it deviates by
    double largest = 0;      ///< the most that one texel deviates by: RMS over its bands
    std::size_t colors = 0;  ///< on which this was measured
    bool all = true;         ///< whether the texture has no others
};
inline constexpr std::size_t kMostColors = std::size_t(1) << 20;

/// Throws FileError if the finest grid does not suffice.
GridChoice chooseGrid(const TexelSource& source, const ColorSpace& space,
                      const UpsamplerOptions& model, double deviation, ModelCache& models);

/// The fewest bits of mantissa with which every texel, as half, is within `difference` (CIEDE2000)
/// of the colour that its unrounded spectrum has. Every colour of the texture is tried.
struct BitsChoice {
    int bits = 0;
    double difference = 0;  ///< the largest that was met
};

/// Throws FileError if all the bits of a half do not suffice.
BitsChoice chooseBits(const TexelSource& source, const Upsampler& upsampler, double difference);

}  // namespace specbake::internal
