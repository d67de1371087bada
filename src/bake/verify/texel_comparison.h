#pragma once

#include "verify/sample_rounding.h"

#include <specbake/core/upsampler.h>

#include <array>
#include <span>
#include <vector>

namespace specbake::internal {

/// How a texel of a spectral image differs from what its texture asks for.
struct TexelDifference {
    bool finite = false;   ///< false: a number of the two is not finite, and nothing was compared
    bool outside = false;  ///< no reflectance has the colour; the file's rule says what was wanted
    std::size_t outOfRange = 0;   ///< bands outside [0, 1], NaN among them
    double de2000 = 0;            ///< beside the light's white
    double xyz = 0;               ///< largest |ΔX|, |ΔY|, |ΔZ|
    bool beyondRounding = false;  ///< by more than the samples' rounding explains
};

/// What the file holds beside the bands, beside what it should be.
struct SampleDifference {
    double size = 0;
    bool beyondRounding = false;
};

/// Compares texels. Immutable: any number of threads may share it.
class TexelComparison {
  public:
    /// What each band of the file gives to the reader: under the model's light, and under D65.
    struct BandWeights {
        std::vector<Imath::V3d> lit, daylit;
    };

    /// `model` must outlive it. `rounding` is that of the bands and of the preview.
    TexelComparison(const Upsampler& model, BandWeights weights, const SampleRounding& rounding);

    /// Beside the colour that the file had to give: that of the texel, or what the file's rule
    /// for colours outside the solid makes of it.
    ///
    /// As (1) is linear, bands that are off by r_m at most have a colour that is off by Σ w_m r_m
    /// at most; to which kArithmetic is added.
    TexelDifference compare(const std::array<float, 3>& color, std::span<const float> bands) const;

    /// The preview R, G, B beside that of the bands (docs/file-format.md). With c_m what band m
    /// gives to it, a value p' may be off by its own rounding and by Σ |c_m| r_m.
    SampleDifference comparePreview(std::span<const float, 3> preview,
                                    std::span<const float> bands) const;

    /// What single-precision arithmetic may cost between a texel and its samples: the dozen of
    /// roundings of a blend of four nodes, weights among them, of values that are at most 2.
    static constexpr double kArithmetic = 32 * 0x1p-24;

  private:
    const Upsampler& model_;
    SampleRounding rounding_;
    std::vector<Imath::V3d> weights_;        ///< w_m
    std::vector<Imath::V3d> previewOfBand_;  ///< c_m: linear Rec.709 under D65
};

}  // namespace specbake::internal
