#include "material/material_map.h"

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

/// Each in [0, 1], NaN being 0; all together at most 1.
std::array<float, 3> bounded(std::array<float, 3> shares, std::size_t count) {
    float sum = 0;
    for (std::size_t j = 0; j < count; ++j) {
        shares[j] = shares[j] > 0 ? std::min(shares[j], 1.0F) : 0;
        sum += shares[j];
    }
    for (std::size_t j = 0; sum > 1 && j < count; ++j) shares[j] /= sum;
    return shares;
}

void check(const TextureInfo& map, const TextureInfo& texture, std::size_t materials) {
    const auto size = [](const Window& w) {
        return std::to_string(w.width) + " x " + std::to_string(w.height);
    };
    if (map.data.width != texture.data.width || map.data.height != texture.data.height) {
        throw FileError(map.path, "a map of materials has the size of its texture, " +
                                      size(texture.data) + ", not " + size(map.data));
    }
    const int channels = map.channels - int(map.alpha.has_value());
    if (std::size_t(channels) < materials) {
        throw FileError(map.path, std::to_string(channels) + " channels for " +
                                      std::to_string(materials) + " materials");
    }
}

}  // namespace

MaterialMap::MaterialMap(Texture& image, const TextureInfo& texture, const ColorSpace& space,
                         const UpsamplerOptions& model, const std::vector<std::string>& materials)
    : image_(image), decoder_(image.info(), asStored()) {
    check(image.info(), texture, materials.size());
    for (const std::string& material : materials) {
        UpsamplerOptions options = model;
        options.material = material;
        upsamplers_.emplace_back(space, options);
    }
}

void MaterialMap::mix(std::span<const Upsampler::Color> colors, std::span<const std::byte> stored,
                      std::span<float> samples, Buffers& buffers) const {
    buffers.shares.resize(colors.size());
    buffers.alpha.resize(colors.size());
    decoder_.decode(stored, colors.size(), buffers.shares.data(), buffers.alpha.data());
    for (auto& shares : buffers.shares) shares = bounded(shares, upsamplers_.size());
    std::vector<float> without;
    for (std::size_t j = 0; j < upsamplers_.size(); ++j) {
        const auto holds = [j](const std::array<float, 3>& shares) { return shares[j] > 0; };
        if (std::ranges::none_of(buffers.shares, holds)) continue;
        if (without.empty()) without.assign(samples.begin(), samples.end());
        addShare(j, colors, without, samples, buffers);
    }
    if (without.empty()) return;
    const auto bands = samples.last(std::size_t(kBandCount) * colors.size());
    for (float& sample : bands) sample = std::clamp(sample, 0.0F, 1.0F);  // what rounding adds
}

void MaterialMap::addShare(std::size_t material, std::span<const Upsampler::Color> colors,
                           std::span<const float> without, std::span<float> samples,
                           Buffers& buffers) const {
    buffers.samples.resize(samples.size());
    const auto target = SampleTarget::planar(
        SampleType::float32, std::as_writable_bytes(std::span(buffers.samples)).data(),
        colors.size() * sizeof(float));
    // Colours without a spectrum are those of the model without a material, and counted there.
    (void)upsamplers_[material].sample(colors, SampleSelection::channels(), target,
                                       buffers.upsampling);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float share = buffers.shares[i % colors.size()][material];
        samples[i] += share * (buffers.samples[i] - without[i]);
    }
}

}  // namespace specbake::internal
