#pragma once

#include <specbake/core/upsampler.h>
#include <specbake/image/texel_decoder.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace specbake::internal {

/// How much of each of some materials a texel is, from an image of the texture's size: its channels
/// in order, as they are stored (integers from 0 to 1), are the shares of the materials. What is
/// left to 1 is of none; shares of more than 1 in all are scaled to 1.
class MaterialMap {
  public:
    /// `image` must outlive it. `model`: of the texture; each material's is the same but for the
    /// material. Throws FileError if the image has another size than the texture or fewer channels
    /// than there are materials.
    MaterialMap(Texture& image, const TextureInfo& texture, const ColorSpace& space,
                const UpsamplerOptions& model, const std::vector<std::string>& materials);

    Texture& image() const { return image_; }

    /// What a thread keeps from run to run.
    struct Buffers {
        std::vector<std::array<float, 3>> shares;
        std::vector<float> alpha;
        std::vector<float> samples;
        Upsampler::Workspace upsampling;
    };

    /// Mixes into the samples of some colours, channel by channel, those of the materials:
    ///
    ///     s = s_none + Σ w_j (s_j − s_none)
    ///
    /// All have the same colour, so that s has it, and w is convex, so that s is bounded.
    /// `stored`: the map's texels that belong to the colours.
    void mix(std::span<const Upsampler::Color> colors, std::span<const std::byte> stored,
             std::span<float> samples, Buffers& buffers) const;

  private:
    void addShare(std::size_t material, std::span<const Upsampler::Color> colors,
                  std::span<const float> without, std::span<float> samples, Buffers& buffers) const;

    Texture& image_;
    TexelDecoder decoder_;
    std::vector<Upsampler> upsamplers_;
};

}  // namespace specbake::internal
