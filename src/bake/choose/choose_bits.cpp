#include "choose/color_survey.h"
#include "choose/tolerances.h"
#include "mantissa.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>

#include <Imath/half.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

namespace specbake::internal {
namespace {

constexpr int kFewest = BakeOptions::kFewestMantissaBits;
constexpr int kMost = BakeOptions::kMostMantissaBits;

/// The largest difference by bits of mantissa.
using Differences = std::array<double, kMost + 1>;
/// One texel's bands.
using Bands = std::span<const float>;

Lab labOf(const Observer& observer, const Spectrum& spectrum) {
    return labFromXYZ(observer.color(spectrum), observer.white());
}

Spectrum unrounded(Bands bands) {
    Spectrum spectrum{};
    std::copy(bands.begin(), bands.end(), spectrum.begin());
    return spectrum;
}

Spectrum rounded(Bands bands, int bits) {
    std::array<Imath::half, kBandCount> halves;
    storeRounded(bands, bits, std::as_writable_bytes(std::span(halves)).data());
    Spectrum spectrum{};
    std::copy_n(halves.begin(), bands.size(), spectrum.begin());
    return spectrum;
}

void compare(const Observer& observer, Bands bands, Differences& largest) {
    const Lab asked = labOf(observer, unrounded(bands));
    for (int bits = kFewest; bits <= kMost; ++bits) {
        double& worst = largest[std::size_t(bits)];
        worst = std::max(worst, ciede2000(asked, labOf(observer, rounded(bands, bits))));
    }
}

Differences differencesOf(const Upsampler& upsampler, std::span<const TexelColor> colors) {
    const SampleSelection wanted = SampleSelection::bands(upsampler.observer().knots());
    std::vector<float> samples(colors.size() * wanted.count());
    const auto target = SampleTarget::interleaved(
        SampleType::float32, reinterpret_cast<std::byte*>(samples.data()), wanted);
    Upsampler::Workspace workspace;
    // What has no spectrum is refused by the bake itself.
    static_cast<void>(upsampler.sample(colors, wanted, target, workspace));
    Differences largest{};
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Bands bands = Bands(samples).subspan(i * wanted.count(), wanted.count());
        compare(upsampler.observer(), bands, largest);
    }
    return largest;
}

}  // namespace

BitsChoice chooseBits(const TexelSource& source, const Upsampler& upsampler, double limit) {
    Differences largest{};
    std::mutex mutex;
    const auto visit = [&](std::span<const ColorCount> counts) {
        std::vector<TexelColor> colors;
        for (const ColorCount& count : counts) colors.push_back(count.color);
        const Differences found = differencesOf(upsampler, colors);
        const std::lock_guard lock(mutex);
        for (std::size_t bits = 0; bits < found.size(); ++bits) {
            largest[bits] = std::max(largest[bits], found[bits]);
        }
    };
    surveyColors(source, visit);
    for (int bits = kFewest; bits <= kMost; ++bits) {
        if (largest[std::size_t(bits)] <= limit) return {bits, largest[std::size_t(bits)]};
    }
    throw FileError(source.info().path, "half samples differ by up to CIEDE2000 " +
                                            std::to_string(largest.back()) +
                                            "; float samples are needed");
}

}  // namespace specbake::internal
