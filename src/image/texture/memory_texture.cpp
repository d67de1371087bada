#include "texture/kept_metadata.h"

#include <specbake/core/error.h>
#include <specbake/image/memory_texture.h>

#include <cstring>

namespace specbake {
namespace {

void require(bool condition, const MemoryImage& image, const char* what) {
    if (!condition) throw ArgumentError(image.name + ": " + what);
}

TextureInfo infoOf(const MemoryImage& image) {
    const auto sideIsValid = [](int side) { return side >= 1 && side <= kLargestSide; };
    require(sideIsValid(image.width) && sideIsValid(image.height), image,
            "an image has sides of 1 to 131072 texels");
    const int color = image.channels - (image.alpha ? 1 : 0);
    require(color == 1 || color == 3, image, "an image has one channel of colour, or three");
    require(!image.alpha || (*image.alpha >= 0 && *image.alpha < image.channels), image,
            "no channel has the number of alpha");
    TextureInfo info;
    info.path = image.name;
    info.data = info.display = {0, 0, image.width, image.height};
    info.channels = image.channels;
    info.alpha = image.alpha;
    info.associatedAlpha = image.alpha && image.associatedAlpha;
    info.sampleType = image.sampleType;
    info.color.space = image.space;
    info.color.reason = "its caller";
    info.attributes = image.attributes;
    internal::keepWhatFits(info.attributes, info.notes);
    return info;
}

}  // namespace

MemoryTexture::MemoryTexture(const MemoryImage& image)
    : info_(infoOf(image)),
      samples_(image.samples),
      rowStride_(image.rowStride == 0 ? info_.bytesPerRow() : image.rowStride) {
    const std::size_t rows = std::size_t(image.height);
    require(rowStride_ >= info_.bytesPerRow(), image, "rows that overlap");
    const std::size_t most = samples_.size() / rowStride_;  // whole rows, but for the last one
    require(most >= rows ||
                (most + 1 == rows && samples_.size() - most * rowStride_ >= info_.bytesPerRow()),
            image, "fewer samples than its sides and channels ask for");
}

void MemoryTexture::readRows(int first, int count, std::span<std::byte> samples) {
    const std::size_t bytes = info_.bytesPerRow();
    if (first < 0 || count < 0 || first > info_.data.height - count ||
        samples.size() < bytes * std::size_t(count)) {
        throw ArgumentError(info_.path + ": rows that the image, or the buffer, does not have");
    }
    for (int row = 0; row < count; ++row) {
        std::memcpy(samples.data() + bytes * std::size_t(row),
                    samples_.data() + rowStride_ * std::size_t(first + row), bytes);
    }
}

}  // namespace specbake
