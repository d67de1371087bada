#include "texture/image_file.h"

#include "texture/isolate/isolated_file.h"
#include "texture/openimageio/openimageio_parts.h"
#include "texture/plain/plain_exr.h"
#include "texture/plain/plain_jpeg.h"
#include "texture/plain/plain_png.h"

#include <specbake/core/error.h>
#include <specbake/image/limits.h>

#include <cstdlib>
#include <filesystem>

namespace specbake::internal {

void ImageFile::readRows(int first, int count, TexelType type, std::span<std::byte> samples) {
    if (samples.size() < rowBytes(type) * std::size_t(count)) {
        throw ArgumentError("a buffer too small for its rows");
    }
    unpackRows(first, count, type, samples);
}

std::size_t ImageFile::rowBytes(TexelType type) const {
    return std::size_t(description_.data.width) * description_.channels.size() *
           bytesPerSample(type);
}

std::unique_ptr<ImageFile> openImageFile(const std::string& path,
                                         const std::optional<std::string>& part) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw FileError(path, "a folder, and no image");
    }
    if (isIsolated(path)) return openIsolated(path, part);
    if (part) return openImageIOParts(path).openImage(path, part);
    if (auto png = openPlainPng(path)) return png;
    if (auto jpeg = openPlainJpeg(path)) return jpeg;
    if (auto exr = openPlainExr(path)) return exr;
    return openImageIOParts(path).openImage(path, {});
}

int validOrientation(int stored) {
    return stored >= 1 && stored <= 8 ? stored : 1;
}

void checkSides(const std::string& path, long long width, long long height) {
    if (width < 1 || height < 1) throw FileError(path, "it has no pixels");
    if (width > kLargestSide || height > kLargestSide) {
        throw FileError(path, "a side of more than " + std::to_string(kLargestSide) + " pixels");
    }
    const auto pixels = std::uint64_t(width) * std::uint64_t(height);
    if (pixels <= limits().pixels) return;
    throw FileError(path, std::to_string(pixels) + " pixels are more than the limit of " +
                              std::to_string(limits().pixels) + " (--max-pixels)");
}

bool isFarOut(const Window& window) {
    constexpr int most = 1 << 29;
    return std::abs(window.x / 2) >= most || std::abs(window.y / 2) >= most;
}

void checkMemory(const std::string& path, std::uint64_t bytes) {
    if (bytes <= limits().memory) return;
    throw FileError(path, "reading it takes " + bytesText(bytes) + ", more than the limit of " +
                              bytesText(limits().memory) + " (--max-memory)");
}

}  // namespace specbake::internal
