#include "texture/image_file.h"
#include "texture/openimageio/openimageio_parts.h"

#include <specbake/core/error.h>
#include <specbake/image/spectral_reader.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace specbake {

using namespace internal;

namespace {

constexpr int kMissing = -1;

/// For each band, the index of its channel in the file.
std::array<int, kBandCount> bandChannels(const std::string& path,
                                         const std::vector<std::string>& names) {
    std::array<int, kBandCount> channels;
    channels.fill(kMissing);
    for (std::size_t c = 0; c < names.size(); ++c) {
        const auto nm = bandWavelength(names[c]);
        if (!nm) continue;
        const double band = (*nm - kFirstWavelength) / kWavelengthStep;
        if (band == std::floor(band) && band >= 0 && band < kBandCount) {
            channels[std::size_t(band)] = int(c);
        }
    }
    for (int band = 0; band < kBandCount; ++band) {
        if (channels[std::size_t(band)] == kMissing) {
            throw FileError(path, "no channel " + bandChannelName(band) +
                                      ": not a spectral image of 380 to 780 nm every 5 nm");
        }
    }
    return channels;
}

/// Of R, G and B, the channels' indices in the file; nothing unless all three are there.
std::optional<std::array<int, kPreviewSamples>> previewChannels(
    const std::vector<std::string>& names) {
    std::array<int, kPreviewSamples> channels{};
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const auto found = std::find(names.begin(), names.end(), std::string(1, "RGB"[i]));
        if (found == names.end()) return {};
        channels[i] = int(found - names.begin());
    }
    return channels;
}

/// Of each texel the samples of some channels, one after the other.
template <std::size_t Count>
void pick(std::span<const float> texels, std::size_t stride, const std::array<int, Count>& channels,
          std::span<float> samples) {
    for (std::size_t t = 0; t * stride < texels.size(); ++t) {
        for (std::size_t i = 0; i < Count; ++i) {
            samples[t * Count + i] = texels[t * stride + std::size_t(channels[i])];
        }
    }
}

}  // namespace

struct SpectralReader::Implementation {
    Implementation(const std::string& name)
        : path(name),
          file(openImageFile(path)),
          channels(bandChannels(path, file->description().channels)),
          preview(previewChannels(file->description().channels)) {
        const ImageDescription& d = file->description();
        header.data = d.data;
        header.display = d.display;
        header.pixelAspectRatio = d.pixelAspectRatio;
        header.alpha = d.alpha.has_value();
    }

    std::string path;
    std::unique_ptr<ImageFile> file;
    std::array<int, kBandCount> channels;
    std::optional<std::array<int, kPreviewSamples>> preview;
    SpectralHeader header;
    std::vector<float> texels;
};

SpectralReader::SpectralReader(const std::string& path)
    : implementation_(std::make_unique<Implementation>(path)) {}
SpectralReader::~SpectralReader() = default;

const SpectralHeader& SpectralReader::header() const {
    return implementation_->header;
}

StorageFacts SpectralReader::facts() const {
    const std::string& path = implementation_->path;
    return openImageIOParts(path).storageFacts(path);
}

TexelType SpectralReader::storedType() const {
    return implementation_->file->description().sampleType;
}

std::vector<std::string> SpectralReader::channels() const {
    std::vector<std::string> names = implementation_->file->description().channels;
    std::sort(names.begin(), names.end());
    return names;
}

bool SpectralReader::hasPreview() const {
    return implementation_->preview.has_value();
}

std::optional<std::string> SpectralReader::text(const std::string& attribute) const {
    return implementation_->file->text(attribute);
}

void SpectralReader::readRows(int first, int count, std::span<float> samples,
                              std::span<float> alpha, std::span<float> preview) {
    Implementation& i = *implementation_;
    const auto channels = i.file->description().channels.size();
    const std::size_t texels = std::size_t(count) * std::size_t(i.header.data.width);
    if (samples.size() < texels * kBandCount || (!alpha.empty() && alpha.size() < texels) ||
        (!preview.empty() && preview.size() < texels * kPreviewSamples)) {
        throw ArgumentError("a buffer too small for its rows");
    }
    i.texels.resize(texels * channels);
    i.file->readRows(first, count, TexelType::float32, std::as_writable_bytes(std::span(i.texels)));
    pick(i.texels, channels, i.channels, samples);
    if (i.preview && !preview.empty()) pick(i.texels, channels, *i.preview, preview);
    const std::optional<int> opacity = i.file->description().alpha;
    for (std::size_t t = 0; opacity && t < alpha.size(); ++t) {
        alpha[t] = i.texels[t * channels + std::size_t(*opacity)];
    }
}

}  // namespace specbake
