#include "demand/spectra.h"

#include <specbake/core/adaptation.h>
#include <specbake/core/error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace specbake::internal {
namespace {

Quadrature quadratureOf(const TableFile& table) {
    const std::string stated = table.fact("quadrature").value_or("");
    if (const auto quadrature = quadratureFromText(stated)) return *quadrature;
    throw FileError(table.name(), "its quadrature '" + stated + "' is not known");
}

bool isFinite(const Upsampler::Color& c) {
    return std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]);
}

}  // namespace

ColorCensus ModelSpectra::sample(std::span<const Upsampler::Color> colors,
                                 std::span<const std::size_t> numbers, float* planes) const {
    const auto target = SampleTarget::planar(
        SampleType::float32, reinterpret_cast<std::byte*>(planes), colors.size() * sizeof(float));
    return model_->sample(colors, SampleSelection::some(numbers, model_->options().bands), target,
                          workspaces_.local());
}

Observer observerOf(const TableFile& table) {
    if (table.bands().count > kBandCount) throw FileError(table.name(), "more bands than 81");
    try {
        return Observer(table.fact("illuminant").value_or(""), quadratureOf(table), table.bands(),
                        table.fact("observer").value_or(std::string(kUsualObserver)));
    } catch (const ArgumentError& error) {
        throw FileError(table.name(), error.what());
    }
}

Adaptation adaptationOf(const TableFile& table, const Observer& observer, const ColorSpace& space) {
    const auto& stored = table.view().header().xyzFromRGB;
    for (const Adaptation adaptation : adaptations()) {
        const Imath::M33d matrix = xyzFromRGB(space, observer, adaptation);
        double largest = 0;
        for (int i = 0; i < 9; ++i) {
            largest = std::max(largest, std::abs(matrix[i / 3][i % 3] - stored[i]));
        }
        if (largest < 1e-6) return adaptation;
    }
    throw FileError(table.name(), "made for the space " + table.fact("space").value_or("?") +
                                      ", while the texture is in " + space.name);
}

TableSpectra::TableSpectra(std::shared_ptr<const TableFile> table) : table_(std::move(table)) {
    const Observer own = observerOf(*table_);
    const Observer daylight("D65", own.quadrature(), own.bands());
    const Imath::M33d rgbFromXYZ =
        xyzFromRGB(*findColorSpace("lin_rec709"), daylight.white()).inverse();
    for (int band = 0; band < own.bands().count; ++band) {
        const Imath::V3d rgb = daylight.weights().at(std::size_t(band)) * rgbFromXYZ;
        previewOfBand_.emplace_back(float(rgb.z), float(rgb.y), float(rgb.x));
    }
}

ColorCensus TableSpectra::sample(std::span<const Upsampler::Color> colors,
                                 std::span<const std::size_t> numbers, float* planes) const {
    const SpectralTable& table = table_->view();
    std::array<float, kPreviewSamples + SpectralTable::kMostBands> samples{};
    float* bands = samples.data() + kPreviewSamples;
    const bool isPreviewed = !numbers.empty() && numbers.front() < kPreviewSamples;
    ColorCensus census;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const auto& [r, g, b] = colors[i];
        if (!isFinite(colors[i])) census.meet(i, Fate::notFinite, 0);
        table.evalBands(table.locate(r, g, b), bands);
        if (isPreviewed) {
            Imath::V3f preview(0.0F);
            for (std::size_t m = 0; m < previewOfBand_.size(); ++m) {
                preview += bands[m] * previewOfBand_[m];
            }
            for (int c = 0; c < 3; ++c) samples[std::size_t(c)] = std::max(preview[c], 0.0F);
        }
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            planes[k * colors.size() + i] = samples.at(numbers[k]);
        }
    }
    return census;
}

}  // namespace specbake::internal
