#include <specbake/core/error.h>
#include <specbake/core/sampling.h>

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace specbake {
namespace {

std::vector<SampleSelection::Tap> wholeSamples(std::size_t first, std::size_t count) {
    std::vector<SampleSelection::Tap> taps(count);
    for (std::size_t i = 0; i < count; ++i) taps[i].first = first + i;
    return taps;
}

SampleSelection::Tap tapAt(double nm) {
    if (!std::isfinite(nm)) throw ArgumentError("a wavelength that is not a finite number");
    const double band =
        std::clamp((nm - kFirstWavelength) / kWavelengthStep, 0.0, double(kBandCount - 1));
    const double below = std::min(std::floor(band), double(kBandCount - 2));
    const auto fraction = float(band - below);
    if (fraction == 1) return {kPreviewSamples + std::size_t(below) + 1, 0};
    return {kPreviewSamples + std::size_t(below), fraction};
}

}  // namespace

SampleSelection::SampleSelection(std::vector<Tap> taps) : taps_(std::move(taps)) {
    bool together = !taps_.empty();
    for (std::size_t i = 0; i < taps_.size(); ++i) {
        together = together && taps_[i].fraction == 0 && taps_[i].first == taps_[0].first + i;
    }
    if (together) run_ = taps_[0].first;
}

SampleSelection SampleSelection::channels() {
    return SampleSelection(wholeSamples(0, kTexelSamples));
}

SampleSelection SampleSelection::bands() {
    return SampleSelection(wholeSamples(kPreviewSamples, kBandCount));
}

SampleSelection SampleSelection::at(std::span<const double> wavelengths) {
    std::vector<Tap> taps(wavelengths.size());
    std::transform(wavelengths.begin(), wavelengths.end(), taps.begin(), tapAt);
    return SampleSelection(std::move(taps));
}

void storeSamples(std::span<const float> values, SampleType type, std::byte* to) {
    if (type == SampleType::float32) {
        std::memcpy(to, values.data(), values.size_bytes());
        return;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Imath::half value = values[i];
        std::memcpy(to + i * sizeof value, &value, sizeof value);
    }
}

}  // namespace specbake
