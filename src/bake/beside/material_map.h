#pragma once

#include "beside/image_beside.h"

#include <specbake/core/upsampler.h>
#include <specbake/image/texel_decoder.h>

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace specbake::internal {

/// How much of each of some materials a texel is, from an image of the texture's size: its channels
/// in order, as they are stored (integers from 0 to 1), are the shares of the materials. What is
/// left to 1 is of none; shares of more than 1 in all are scaled to 1.
///
///     s = s_none + Σ w_j (s_j − s_none)
///
/// All have the same colour, so that s has it, and the mixture is convex, so that s is bounded.
class MaterialMap : public ImageBeside {
  public:
    /// `model`: of the texture; each material's is the same but for the material. Throws FileError
    /// if the image has another size than the texture or fewer channels than there are materials.
    MaterialMap(Texture& image, const TextureInfo& texture, const ColorSpace& space,
                const UpsamplerOptions& model, const std::vector<std::string>& materials);

    void change(std::span<const Upsampler::Color> colors, std::span<const std::byte> stored,
                std::span<float> samples, BesideCensus& census) const override;

  private:
    /// What a thread keeps from run to run.
    struct Buffers {
        std::vector<std::array<float, 3>> shares;
        std::vector<float> alpha;
        std::vector<float> without;  ///< samples of no material
        std::vector<float> samples;  ///< of one
        Upsampler::Workspace upsampling;
    };
    void addShare(std::size_t material, std::span<const Upsampler::Color> colors,
                  std::span<float> samples, Buffers& buffers) const;

    TexelDecoder decoder_;
    std::vector<Upsampler> upsamplers_;
    mutable tbb::enumerable_thread_specific<Buffers> buffers_;
};

}  // namespace specbake::internal
