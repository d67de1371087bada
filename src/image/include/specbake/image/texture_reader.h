#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>
#include <specbake/image/image_types.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace specbake {

/// What a texture's file says of it.
struct TextureInfo {
    std::string path;
    Window data;     ///< where there are pixels
    Window display;  ///< what is meant to be seen
    float pixelAspectRatio = 1;
    int channels = 0;                           ///< 1 to 4, alpha included
    std::optional<int> alpha;                   ///< the index of the alpha channel
    bool associatedAlpha = false;               ///< colour in the file is multiplied by alpha
    SampleType sampleType = SampleType::uint8;  ///< as stored, or the next larger that is offered
    ColorSpace automaticSpace;                  ///< what `--space auto` means for this file
    Attributes attributes;                      ///< metadata worth keeping
    std::vector<std::string> notes;             ///< one line each on what of the file is not used

    std::size_t bytesPerRow() const {
        return std::size_t(data.width) * std::size_t(channels) * bytesPerSample(sampleType);
    }
};

/// Reads the first subimage and mip level of any file that OpenImageIO reads, by rows.
/// Throws FileError, with the file and the reason, for what cannot be read: absent, truncated,
/// deep, volumetric, larger than kLargestSide, more than four channels, four without an alpha.
class SPECBAKE_API TextureReader {
  public:
    /// `threads` unpack an EXR beside the caller, if there are more than 1; of all readers in the
    /// process, the last that was made decides.
    explicit TextureReader(const std::string& path, int threads = 1);
    ~TextureReader();
    TextureReader(TextureReader&&) noexcept;
    TextureReader& operator=(TextureReader&&) noexcept;

    const TextureInfo& info() const;

    /// Rows [first, first + count) of the data window, counted from 0, as they are stored:
    /// info().sampleType samples, channels interleaved. Rows are best asked for in order.
    void readRows(int first, int count, std::span<std::byte> samples);

  private:
    struct SPECBAKE_LOCAL Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Turns stored samples into linear colour: undoes the alpha association and the transfer curve.
/// Immutable: any number of threads may share it.
class SPECBAKE_API TexelDecoder {
  public:
    /// `space` is the texture's, or another that its user knows better.
    /// Throws FileError if the texture has too few channels for the space (grey XYZ).
    TexelDecoder(const TextureInfo& info, const ColorSpace& space);

    /// `count` texels of `samples` to linear colour (grey is given to all three components) and,
    /// if the texture has alpha, `alpha[i]` (else alpha is not touched). A transparent texel
    /// (alpha 0) of an associated file keeps its colour as it is stored.
    void decode(std::span<const std::byte> samples, std::size_t count, std::array<float, 3>* color,
                float* alpha) const;

  private:
    float sample(const std::byte* at) const;
    float linear(float encoded) const;

    int channels_;
    std::optional<int> alpha_;
    bool associated_;
    SampleType type_;
    Transfer transfer_;
    std::vector<float> linearOf_;  ///< by stored integer value; empty for half and float
};

}  // namespace specbake
