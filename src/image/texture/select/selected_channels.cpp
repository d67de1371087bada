#include "texture/select/selected_channels.h"

#include "texture/color/lab_and_inks.h"
#include "texture/select/channel_names.h"

#include <cstring>
#include <numeric>
#include <utility>

namespace specbake::internal {
namespace {

/// Inks and Lab are colours all together, in their order; a part of them are mere numbers.
void forgetPartialColors(ImageDescription& d, const ChannelChoice& choice) {
    const std::size_t colors = colorNames(d.signs.model).size();
    const std::size_t chosen = choice.channels.size() - (choice.alpha ? 1 : 0);
    bool whole = chosen == colors;
    for (std::size_t c = 0; whole && c < colors; ++c) whole = choice.channels[c] == int(c);
    if (whole || colors == 0) return;
    d.notes.emplace_back("of " + std::string(isLab(d.signs.model) ? "Lab" : "its inks") +
                         " a part is read: as it is stored, without the meaning of the whole");
    d.signs = {};
}

ImageDescription described(ImageDescription d, const ChannelChoice& choice) {
    forgetPartialColors(d, choice);
    std::vector<std::string> names;
    for (const int c : choice.channels) names.push_back(componentOf(d.channels[std::size_t(c)]));
    d.channels = std::move(names);
    d.alpha = choice.alpha ? std::optional(int(choice.channels.size()) - 1) : std::nullopt;
    d.associatedAlpha = choice.associatedAlpha;
    d.notes.insert(d.notes.end(), choice.notes.begin(), choice.notes.end());
    return d;
}

/// The channels `from` of each texel, side by side. A texel takes `stride` bytes, a sample `Bytes`.
template <std::size_t Bytes>
void pick(const std::vector<std::byte>& row, std::size_t stride, const std::vector<int>& from,
          std::byte* to) {
    for (std::size_t texel = 0; texel < row.size(); texel += stride) {
        for (const int c : from) {
            std::memcpy(to, row.data() + texel + std::size_t(c) * Bytes, Bytes);
            to += Bytes;
        }
    }
}

}  // namespace

SelectedChannels::SelectedChannels(std::unique_ptr<ImageFile> file, const ChannelChoice& choice)
    : ImageFile(described(file->description(), choice)),
      file_(std::move(file)),
      channels_(choice.channels) {}

void SelectedChannels::unpackRows(int first, int count, TexelType type,
                                  std::span<std::byte> samples) {
    const std::size_t bytes = bytesPerSample(type);
    const std::size_t stride = file_->description().channels.size() * bytes;
    row_.resize(std::size_t(description().data.width) * stride);
    for (int row = 0; row < count; ++row) {
        file_->readRows(first + row, 1, type, row_);
        std::byte* to = samples.data() + std::size_t(row) * rowBytes(type);
        if (bytes == 1) {
            pick<1>(row_, stride, channels_, to);
        } else if (bytes == 2) {
            pick<2>(row_, stride, channels_, to);
        } else {
            pick<4>(row_, stride, channels_, to);
        }
    }
}

std::unique_ptr<ImageFile> withChannels(std::unique_ptr<ImageFile> file,
                                        const ChannelChoice& choice) {
    const ImageDescription& d = file->description();
    std::vector<int> all(d.channels.size());
    std::iota(all.begin(), all.end(), 0);
    const bool alike = choice.channels == all && choice.notes.empty() &&
                       choice.alpha == d.alpha.has_value() &&
                       choice.associatedAlpha == d.associatedAlpha;
    if (alike) return file;
    return std::make_unique<SelectedChannels>(std::move(file), choice);
}

}  // namespace specbake::internal
