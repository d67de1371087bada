#pragma once

#include <specbake/core/api.h>
#include <specbake/image/texture.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace specbake {

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
    TexelType type_;
    Transfer transfer_;
    std::vector<float> linearOf_;  ///< by stored integer value; empty for half and float
};

}  // namespace specbake
