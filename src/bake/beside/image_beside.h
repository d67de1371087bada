#pragma once

#include <specbake/core/upsampler.h>
#include <specbake/image/texture.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace specbake::internal {

/// Texels that did not get all that an image beside the texture asks for.
struct BesideCensus {
    std::size_t missed = 0;
    double largest = 0;  ///< CIEDE2000 from what was asked for

    void add(const BesideCensus& other) {
        missed += other.missed;
        largest = std::max(largest, other.largest);
    }
};

/// An image of the texture's size that says more about each texel, and changes its samples.
class ImageBeside {
  public:
    /// `image` must outlive it. Throws FileError, with `what` the image is, if the sizes differ.
    ImageBeside(Texture& image, const TextureInfo& texture, const char* what);
    virtual ~ImageBeside() = default;
    ImageBeside(const ImageBeside&) = delete;
    ImageBeside& operator=(const ImageBeside&) = delete;

    Texture& image() const { return image_; }

    /// `samples`: those of the colours, channel by channel as a baked file has them. `stored`: the
    /// image's texels that belong to the colours. By any number of threads at once.
    virtual void change(std::span<const Upsampler::Color> colors, std::span<const std::byte> stored,
                        std::span<float> samples, BesideCensus& census) const = 0;

  private:
    Texture& image_;
};

}  // namespace specbake::internal
