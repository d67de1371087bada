#include "choose/color_survey.h"
#include "choose/tolerances.h"
#include "mantissa.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>

#include <Imath/half.h>

#include <algorithm>
#include <mutex>
#include <string>

namespace specbake {
namespace {

constexpr std::size_t kRun = 64;  ///< colours looked up at a time
/// The largest difference by bits of mantissa.
using Differences = std::array<double, kHalfMantissaBits + 1>;
/// One run's samples, plane by plane.
using Planes = std::array<std::array<std::uint16_t, kRun>, kNodeValues>;

Lab unroundedColor(const Observer& observer, const Mix& mix) {
    Spectrum s;
    for (std::size_t m = 0; m < s.size(); ++m) {
        s[m] = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            s[m] += double(mix.weights[k]) * double(mix.values[k][kPreviewValues + m]);
        }
    }
    return labFromXYZ(observer.color(s), observer.white());
}

Lab roundedColor(const Observer& observer, const Planes& planes, std::size_t texel, int bits) {
    Spectrum s;
    for (std::size_t m = 0; m < s.size(); ++m) {
        std::uint16_t sample = planes[kPreviewValues + m][texel];
        roundMantissa(std::as_writable_bytes(std::span(&sample, 1)), bits);
        Imath::half value;
        value.setBits(sample);
        s[m] = double(float(value));
    }
    return labFromXYZ(observer.color(s), observer.white());
}

void compareRun(const Job& job, SpectrumLookup& lookup, std::span<const TexelColor> colors,
                Differences& largest) {
    std::array<Mix, kRun> mixes;
    SpectrumLookup::Scratch scratch;
    TexelCensus census;
    const auto used = std::span(mixes).first(colors.size());
    lookup.locate(colors, 0, used, scratch, census);
    Planes planes;
    blend(used, BlendType::half, reinterpret_cast<std::byte*>(planes.data()), sizeof planes[0]);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Lab asked = unroundedColor(job.observer, mixes[i]);
        for (int bits = kFewestMantissaBits; bits <= kHalfMantissaBits; ++bits) {
            const Lab given = roundedColor(job.observer, planes, i, bits);
            double& worst = largest[std::size_t(bits)];
            worst = std::max(worst, ciede2000(asked, given));
        }
    }
}

}  // namespace

BitsChoice chooseBits(const Job& job, SpectrumLookup& lookup, double limit) {
    Differences largest{};
    std::mutex mutex;
    const auto visit = [&](std::span<const TexelColor> colors) {
        Differences found{};
        for (std::size_t first = 0; first < colors.size(); first += kRun) {
            compareRun(job, lookup, colors.subspan(first, std::min(kRun, colors.size() - first)),
                       found);
        }
        const std::lock_guard lock(mutex);
        for (std::size_t bits = 0; bits < found.size(); ++bits) {
            largest[bits] = std::max(largest[bits], found[bits]);
        }
    };
    surveyColors(job.path, job.decoder, job.threads, job.stop, visit);
    for (int bits = kFewestMantissaBits; bits <= kHalfMantissaBits; ++bits) {
        if (largest[std::size_t(bits)] <= limit) return {bits, largest[std::size_t(bits)]};
    }
    throw FileError(job.path, "half samples differ by up to CIEDE2000 " +
                                  std::to_string(largest.back()) + "; float samples are needed");
}

}  // namespace specbake
