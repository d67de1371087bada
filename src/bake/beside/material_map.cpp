#include "beside/material_map.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <utility>

namespace specbake::internal {
namespace {

/// Shares are numbers, no colours: nothing is decoded.
ColorMeaning asStored() {
    ColorMeaning meaning;
    meaning.space = *findColorSpace("lin_rec709");
    return meaning;
}

/// The first `count`, each in [0, 1], NaN being 0; all together at most 1. The others are 0.
std::array<float, 3> bounded(const std::array<float, 3>& stored, std::size_t count) {
    std::array<float, 3> shares{};
    float sum = 0;
    for (std::size_t j = 0; j < count; ++j) {
        shares[j] = stored[j] > 0 ? std::min(stored[j], 1.0F) : 0;
        sum += shares[j];
    }
    for (std::size_t j = 0; sum > 1 && j < count; ++j) shares[j] /= sum;
    return shares;
}

void checkChannels(const TextureInfo& map, std::size_t materials) {
    const int channels = map.channels - int(map.alpha.has_value());
    if (std::size_t(channels) >= materials) return;
    throw FileError(map.path, std::to_string(channels) + " channels for " +
                                  std::to_string(materials) + " materials");
}

}  // namespace

MaterialMap::MaterialMap(Texture& itsImage, const TextureInfo& texture, const ColorSpace& space,
                         const UpsamplerOptions& model, const std::vector<std::string>& materials)
    : ImageBeside(itsImage, texture, "a map of materials"), decoder_(image().info(), asStored()) {
    checkChannels(image().info(), materials.size());
    for (const std::string& material : materials) {
        UpsamplerOptions options = model;
        options.material = material;
        upsamplers_.emplace_back(space, options);
    }
}

void MaterialMap::change(std::span<const Upsampler::Color> colors,
                         std::span<const std::byte> stored, std::span<float> samples,
                         BesideCensus& /*census*/) const {
    Buffers& buffers = buffers_.local();
    buffers.shares.resize(colors.size());
    buffers.alpha.resize(colors.size());
    decoder_.decode(stored, colors.size(), buffers.shares.data(), buffers.alpha.data());
    for (auto& shares : buffers.shares) shares = bounded(shares, upsamplers_.size());
    const auto isEmpty = [](const auto& shares) { return shares == std::array<float, 3>{}; };
    if (std::ranges::all_of(buffers.shares, isEmpty)) return;
    buffers.without.assign(samples.begin(), samples.end());
    for (std::size_t j = 0; j < upsamplers_.size(); ++j) {
        const auto holds = [j](const std::array<float, 3>& shares) { return shares[j] > 0; };
        if (std::ranges::any_of(buffers.shares, holds)) addShare(j, colors, samples, buffers);
    }
    const auto bands = samples.subspan(kPreviewSamples * colors.size());
    for (float& sample : bands) sample = std::clamp(sample, 0.0F, 1.0F);  // what rounding adds
}

void MaterialMap::addShare(std::size_t material, std::span<const Upsampler::Color> colors,
                           std::span<float> samples, Buffers& buffers) const {
    buffers.samples.resize(samples.size());
    const auto target = SampleTarget::planar(
        SampleType::float32, std::as_writable_bytes(std::span(buffers.samples)).data(),
        colors.size() * sizeof(float));
    // Colours without a spectrum are those of the model without a material, and counted there.
    const Upsampler& upsampler = upsamplers_[material];
    (void)upsampler.sample(colors, SampleSelection::channels(upsampler.options().bands), target,
                           buffers.upsampling);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float share = buffers.shares[i % colors.size()][material];
        samples[i] += share * (buffers.samples[i] - buffers.without[i]);
    }
}

}  // namespace specbake::internal
