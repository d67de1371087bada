#pragma once

#include <specbake/core/api.h>
#include <specbake/image/texture.h>

namespace specbake {

/// An image in an array: rows from the top, within a row texel by texel, channels interleaved.
struct MemoryImage {
    std::string name = "image";  ///< what an error calls it
    int width = 0;               ///< 1 to kLargestSide, as height
    int height = 0;
    int channels = 3;              ///< 1 or 3 of colour, and one of alpha if there is any
    std::optional<int> alpha;      ///< the index of the alpha channel
    bool associatedAlpha = false;  ///< colour is multiplied by alpha
    TexelType sampleType = TexelType::float32;
    ColorSpace space = *findColorSpace("lin_rec709");
    Attributes attributes;  ///< to be kept in what is made of it
    std::span<const std::byte> samples;
    std::size_t rowStride = 0;  ///< bytes from row to row; 0: rows follow each other
};

/// The image as a texture. Its samples are not copied: they must outlive the texture.
class SPECBAKE_API MemoryTexture : public Texture {
  public:
    /// Throws ArgumentError for sides or channels out of range, or samples that are too few.
    explicit MemoryTexture(const MemoryImage& image);

    const TextureInfo& info() const override { return info_; }
    void readRows(int first, int count, std::span<std::byte> samples) override;

  private:
    TextureInfo info_;
    std::span<const std::byte> samples_;
    std::size_t rowStride_;
};

}  // namespace specbake
