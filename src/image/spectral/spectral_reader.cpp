#include "texture/image_file.h"
#include "texture/openimageio/openimageio_parts.h"

#include <specbake/core/error.h>
#include <specbake/core/quadrature.h>
#include <specbake/image/spectral_reader.h>

#include <algorithm>
#include <array>
#include <map>

namespace specbake {

using namespace internal;

namespace {

constexpr double kLongest = 1e6;  ///< nm; longer waves are no light

/// The bands that are read: where they stand, and the indices of their channels in the file.
struct BandChannels {
    std::vector<double> wavelengths;  ///< ascending
    std::vector<int> channels;
};

/// The bands that specbake says it wrote; nothing of a file of another program's.
std::optional<Wavelengths> writtenBands(const std::string& path, const ImageFile& file) {
    const auto text = file.text("specbake:wavelengths");
    if (!text && !file.text("specbake:version")) return {};
    try {
        return text ? parseWavelengths(*text) : Wavelengths();
    } catch (const ArgumentError& error) {
        throw FileError(path, std::string("specbake:wavelengths: ") + error.what());
    }
}

void refuseUnlessThere(const std::string& path, const Wavelengths& written,
                       const std::map<std::string, int>& there) {
    for (int band = 0; band < written.count; ++band) {
        const std::string name = bandChannelName(written.at(band));
        if (there.contains(name)) continue;
        throw FileError(path, "no channel " + name + ": not a spectral image of " +
                                  wavelengthsText(written) + " nm, as it says");
    }
}

BandChannels bandChannels(const std::string& path, const ImageFile& file) {
    std::map<std::string, int> there;  // by the name that we would give
    std::map<double, int> byWavelength;
    const std::vector<std::string>& names = file.description().channels;
    for (std::size_t c = 0; c < names.size(); ++c) {
        const auto nm = bandWavelength(names[c]);
        if (!nm || *nm > kLongest) continue;
        there[bandChannelName(*nm)] = int(c);
        byWavelength[*nm] = int(c);
    }
    BandChannels found;
    if (const auto written = writtenBands(path, file)) {
        refuseUnlessThere(path, *written, there);
        for (int band = 0; band < written->count; ++band) {
            found.wavelengths.push_back(written->at(band));
            found.channels.push_back(there.at(bandChannelName(written->at(band))));
        }
        return found;
    }
    if (byWavelength.size() < 2) {
        throw FileError(path, "has no two channels such as " + bandChannelName(400) +
                                  ": not a spectral image of reflectances");
    }
    for (const auto& [nm, channel] : byWavelength) {
        found.wavelengths.push_back(nm);
        found.channels.push_back(channel);
    }
    return found;
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
void pick(std::span<const float> texels, std::size_t stride, std::span<const int> channels,
          std::span<float> samples) {
    for (std::size_t t = 0; t * stride < texels.size(); ++t) {
        for (std::size_t i = 0; i < channels.size(); ++i) {
            samples[t * channels.size() + i] = texels[t * stride + std::size_t(channels[i])];
        }
    }
}

}  // namespace

struct SpectralReader::Implementation {
    Implementation(const std::string& name)
        : path(name),
          file(openImageFile(path)),
          bands(bandChannels(path, *file)),
          preview(previewChannels(file->description().channels)) {
        const ImageDescription& d = file->description();
        header.data = d.data;
        header.display = d.display;
        header.pixelAspectRatio = d.pixelAspectRatio;
        header.alpha = d.alpha.has_value();
    }

    std::string path;
    std::unique_ptr<ImageFile> file;
    BandChannels bands;
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
    std::optional<StorageFacts> known = implementation_->file->facts();
    StorageFacts facts = known ? *std::move(known) : openImageIOParts(path).storageFacts(path);
    std::sort(facts.attributes.begin(), facts.attributes.end());
    return facts;
}

const std::vector<double>& SpectralReader::wavelengths() const {
    return implementation_->bands.wavelengths;
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
    if (samples.size() < texels * i.bands.channels.size() ||
        (!alpha.empty() && alpha.size() < texels) ||
        (!preview.empty() && preview.size() < texels * kPreviewSamples)) {
        throw ArgumentError("a buffer too small for its rows");
    }
    i.texels.resize(texels * channels);
    i.file->readRows(first, count, TexelType::float32, std::as_writable_bytes(std::span(i.texels)));
    pick(i.texels, channels, i.bands.channels, samples);
    if (i.preview && !preview.empty()) pick(i.texels, channels, *i.preview, preview);
    const std::optional<int> opacity = i.file->description().alpha;
    for (std::size_t t = 0; opacity && t < alpha.size(); ++t) {
        alpha[t] = i.texels[t * channels + std::size_t(*opacity)];
    }
}

}  // namespace specbake
