#include "color/knot_place.h"

#include <specbake/core/error.h>
#include <specbake/core/quadrature.h>
#include <specbake/core/sampling.h>

#include <Imath/half.h>

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

SampleSelection::Tap tapAt(double nm, const Wavelengths& knots) {
    if (!std::isfinite(nm)) throw ArgumentError("a wavelength that is not a finite number");
    const auto [below, ofNext] = internal::placeOn(knots, nm);
    const auto fraction = float(ofNext);
    if (fraction == 1) return {kPreviewSamples + below + 1, 0};
    return {kPreviewSamples + below, fraction};
}

}  // namespace

SampleSelection::SampleSelection(std::vector<Tap> taps) : taps_(std::move(taps)) {
    bool together = !taps_.empty();
    for (std::size_t i = 0; i < taps_.size(); ++i) {
        together = together && taps_[i].fraction == 0 && taps_[i].first == taps_[0].first + i;
    }
    if (together) run_ = taps_[0].first;
}

SampleSelection SampleSelection::channels(const Wavelengths& bands) {
    std::vector<Tap> taps = wholeSamples(0, kPreviewSamples);
    const SampleSelection rest = SampleSelection::bands(bands);
    taps.insert(taps.end(), rest.taps().begin(), rest.taps().end());
    return SampleSelection(std::move(taps));
}

SampleSelection SampleSelection::bands(const Wavelengths& bands) {
    if (bands.knots() == bands) {
        return SampleSelection(wholeSamples(kPreviewSamples, std::size_t(bands.count)));
    }
    return at(listed(bands), bands);
}

SampleSelection SampleSelection::some(std::span<const std::size_t> numbers,
                                      const Wavelengths& bands) {
    const SampleSelection all = channels(bands);
    std::vector<Tap> taps;
    taps.reserve(numbers.size());
    for (const std::size_t number : numbers) taps.push_back(all.taps_.at(number));
    return SampleSelection(std::move(taps));
}

SampleSelection SampleSelection::at(std::span<const double> wavelengths, const Wavelengths& bands) {
    std::vector<Tap> taps;
    taps.reserve(wavelengths.size());
    for (const double nm : wavelengths) taps.push_back(tapAt(nm, bands.knots()));
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
