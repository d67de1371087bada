#pragma once

#include <specbake/core/api.h>
#include <specbake/core/samples.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace specbake {

/// Which samples of a texel are wanted, and in which order.
class SPECBAKE_API SampleSelection {
  public:
    /// What a file of these bands, the model's own, holds: the preview, and each band.
    static SampleSelection channels(const Wavelengths& bands = {});
    /// The bands.
    static SampleSelection bands(const Wavelengths& bands = {});
    /// Some of channels(), by their numbers there.
    static SampleSelection some(std::span<const std::size_t> numbers,
                                const Wavelengths& bands = {});
    /// Reflectance at these wavelengths, nm, of a model of those bands: linear between them; below
    /// the first and beyond the last, theirs. Throws ArgumentError for what is not finite.
    static SampleSelection at(std::span<const double> wavelengths, const Wavelengths& bands = {});

    std::size_t count() const { return taps_.size(); }
    /// Where they are whole samples that follow each other, the first of them.
    std::optional<std::size_t> run() const { return run_; }
    /// Whether they are whole samples from the first on, as those of a file are.
    bool isChannels() const { return run_ == 0U && count() > kPreviewSamples; }

    /// The sample `first`, or between it and the next: (1 - fraction) and fraction of them.
    struct Tap {
        std::size_t first = 0;
        float fraction = 0;
    };
    std::span<const Tap> taps() const { return taps_; }

  private:
    explicit SampleSelection(std::vector<Tap> taps);

    std::vector<Tap> taps_;
    std::optional<std::size_t> run_;
};

/// Where samples go, by steps in bytes: sample k of colour i to `to + i * perColor + k *
/// perSample`. `to` and the steps are multiples of a sample's size. Nothing but the samples is
/// written.
struct SampleTarget {
    SampleType type = SampleType::float32;
    std::byte* to = nullptr;
    std::size_t perColor = 0;
    std::size_t perSample = 0;

    /// All samples of a colour side by side.
    static SampleTarget interleaved(SampleType type, std::byte* to, const SampleSelection& wanted) {
        const std::size_t size = bytesPerSample(type);
        return {type, to, wanted.count() * size, size};
    }
    /// A plane a sample, `stride` bytes apart.
    static SampleTarget planar(SampleType type, std::byte* to, std::size_t stride) {
        return {type, to, bytesPerSample(type), stride};
    }
};

/// `values` as samples of that type, side by side; halves are rounded to nearest even.
SPECBAKE_API void storeSamples(std::span<const float> values, SampleType type, std::byte* to);

}  // namespace specbake
