#pragma once

#include <specbake/core/api.h>
#include <specbake/image/texture.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace specbake {

/// Turns stored samples into linear colour: undoes the alpha association and the transfer curve.
/// Immutable: any number of threads may share it.
class SPECBAKE_API TexelDecoder {
  public:
    /// `meaning` is the texture's, or another that its user knows better.
    /// Throws FileError if the texture has too few channels for the space (grey XYZ).
    TexelDecoder(const TextureInfo& info, const ColorMeaning& meaning);

    /// `count` texels of `samples` to linear colour of the meaning's space (grey is given to all
    /// three components) and, if the texture has alpha, `alpha[i]` (else alpha is not touched). A
    /// transparent texel (alpha 0) of an associated file keeps its colour as it is stored.
    void decode(std::span<const std::byte> samples, std::size_t count, std::array<float, 3>* color,
                float* alpha) const;

  private:
    float sample(const std::byte* at) const;
    float linear(std::size_t component, float encoded) const;
    float opacity(const std::byte* texel) const;
    void decodeByCurves(const std::byte* texels, std::size_t count, std::array<float, 3>* color,
                        float* alpha) const;
    void decodeByTransform(const std::byte* texels, std::size_t count, std::array<float, 3>* color,
                           float* alpha) const;

    std::size_t channels_;
    std::size_t colors_;  ///< channels without alpha
    std::optional<int> alpha_;
    bool associated_;
    TexelType type_;
    Transfer transfer_;
    std::shared_ptr<const SampledCurves> curves_;
    std::shared_ptr<const PixelTransform> transform_;
    std::vector<float> linearOf_;  ///< by stored integer value; empty for half and float
    std::size_t nextTable_ = 0;    ///< from one component's table to the next; 0: they share it
};

}  // namespace specbake
