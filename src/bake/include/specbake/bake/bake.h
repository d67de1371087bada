#pragma once

#include <specbake/core/api.h>
#include <specbake/core/upsampler_options.h>
#include <specbake/image/spectral_layout.h>
#include <specbake/image/texture_reader.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace specbake {

class ModelCache;

/// How a texture is baked. The defaults are those of `specbake bake`.
struct BakeOptions {
    ReadOptions read;   ///< of a texture in a file
    ColorWishes color;  ///< none: what the texture says of its numbers
    UpsamplerOptions model;
    /// Instead of `model.material`, texel by texel: an image of the texture's size whose first
    /// channels are the shares of `mappedMaterials`, in their order: integers from 0 to 1, not
    /// decoded. What is left to 1 is of no material; of more than 1 in all, each is its part.
    std::optional<std::filesystem::path> materialMap;
    std::vector<std::string> mappedMaterials;  ///< of materialNames(), at most kMostMapped
    /// The same texture under a second light: spectra have these colours too, where reflectances
    /// have both, and else the nearest to them. (1, 1, 1) is the perfect reflector in both.
    std::optional<std::filesystem::path> second;
    std::string secondLight;  ///< as isIlluminant() knows it; another than the first
    /// Instead of `model.grid`: the coarsest grid whose spectra deviate by at most this from the
    /// directly solved ones: RMS over the bands and all texels. Every colour of the texture is
    /// solved to know; of more than 2^20 colours a sample of as many.
    std::optional<double> maxDeviation;
    int bits = kMostMantissaBits;  ///< of the mantissa of half samples
    /// Instead of `bits`: the fewest that keep every texel within this CIEDE2000.
    std::optional<double> maxDE;
    StorageOptions storage;
    /// Metadata that the file carries beside the texture's, or instead of them, under names that
    /// are free (isFreeAttributeName()).
    Attributes attributes;
    std::shared_ptr<ModelCache> models;    ///< shared with other bakes; none: no one else's
    int threads = 0;                       ///< 0: all cores
    std::stop_token stop;                  ///< when stopped, bake() throws Cancelled
    std::function<void(double)> progress;  ///< called with 0 to 1, from one thread at a time

    static constexpr int kFewestMantissaBits = 4;
    static constexpr int kMostMantissaBits = 10;  ///< all that a half has
    static constexpr std::size_t kMostMapped = 3;

    /// Whether a bake can begin. `reason`, if it is given, says why not: one line.
    [[nodiscard]] SPECBAKE_API bool isValid(std::string* reason = nullptr) const;
};

/// What was done, for `--stats` and `-v`.
struct BakeStatistics {
    std::string space;
    ColorSource colorSource = ColorSource::user;  ///< who says that it is in that space
    std::string colorReason;                      ///< the same for people
    std::string illuminant;
    std::optional<Adaptation> adapted;  ///< if the light is not the space's own white
    std::size_t texels = 0;
    int grid = 0;                      ///< nodes an axis, 0 without a grid
    int bits = 0;                      ///< of the samples' mantissa
    std::optional<double> deviation;   ///< what maxDeviation met
    double largestDeviation = 0;       ///< then: the most of one texel, RMS over its bands
    std::size_t deviationColors = 0;   ///< then: on how many colours it was measured
    bool deviationOfAll = true;        ///< then: whether the texture has no others
    std::optional<double> difference;  ///< what maxDE met: the largest CIEDE2000
    std::size_t directTexels = 0;      ///< not, or not only, through the grid
    std::size_t outsideTexels = 0;     ///< whose colour no reflectance has
    double largestMove = 0;        ///< of these: CIEDE2000 from the colour asked for to that given
    std::string secondIlluminant;  ///< empty without one
    std::size_t secondMissed = 0;  ///< texels with another colour under the second light
    double largestSecondMiss = 0;  ///< of these: CIEDE2000 under that light
    std::size_t nodesSolved = 0;   ///< of the model, also by those that share it
    double seconds = 0;
    std::vector<std::string> notes;  ///< what of the texture was not used; of samples
};

/// The texture to the spectral image `output`, which appears whole or not at all. The bytes of the
/// output depend on the input and the options but not on the threads.
/// Throws FileError, ArgumentError, Cancelled.
SPECBAKE_API BakeStatistics bake(Texture& texture, const std::filesystem::path& output,
                                 const BakeOptions& options);

/// The same for a texture in a file.
SPECBAKE_API BakeStatistics bake(const std::string& input, const std::filesystem::path& output,
                                 const BakeOptions& options);

/// Takes a spectral image row by row, without a file. Called by one thread at a time.
struct RowReceiver {
    /// Before the first row: windows, alpha, attributes. The channels are channelNames().
    std::function<void(const SpectralHeader&)> begin;
    /// Row `row` of the data window, counted from 0, in order: channel by channel, samples of
    /// `options.storage.sampleType`.
    std::function<void(int row, std::span<const std::byte> samples)> row;
};

/// The texture to a receiver. Of `options.storage` the sample type counts; tiles and mip levels
/// are refused by an ArgumentError, since rows have none.
SPECBAKE_API BakeStatistics bake(Texture& texture, const RowReceiver& receiver,
                                 const BakeOptions& options);

}  // namespace specbake
