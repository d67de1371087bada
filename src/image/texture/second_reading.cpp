#include "texture/image_file.h"
#include "texture/openimageio/openimageio_parts.h"
#include "texture/plain/plain_exr.h"
#include "texture/plain/plain_jpeg.h"
#include "texture/plain/plain_png.h"

#include <specbake/image/second_reading.h>

#include <algorithm>
#include <cstring>

namespace specbake {

using namespace internal;

namespace {

std::unique_ptr<ImageFile> openPlain(const std::string& path) {
    if (auto png = openPlainPng(path)) return png;
    if (auto jpeg = openPlainJpeg(path)) return jpeg;
    return openPlainExr(path);
}

const char* differenceOf(const ImageDescription& a, const ImageDescription& b) {
    if (a.data != b.data) return "the data window";
    if (a.display != b.display) return "the display window";
    if (a.channels != b.channels) return "the channels";
    if (a.alpha != b.alpha || (a.alpha && a.associatedAlpha != b.associatedAlpha)) return "alpha";
    if (a.sampleType != b.sampleType) return "the type of the samples";
    if (a.signs != b.signs) return "what it says of its colours";
    return nullptr;
}

/// Of the samples, some rows at a time.
std::optional<std::string> differentRow(ImageFile& a, ImageFile& b) {
    constexpr int together = 16;  // rows of a ZIP chunk
    const ImageDescription& d = a.description();
    const std::size_t rowBytes =
        std::size_t(d.data.width) * d.channels.size() * bytesPerSample(d.sampleType);
    std::vector<std::byte> first(rowBytes * together);
    std::vector<std::byte> second(rowBytes * together);
    for (int row = 0; row < d.data.height; row += together) {
        const int rows = std::min(together, d.data.height - row);
        a.readRows(row, rows, d.sampleType, first);
        b.readRows(row, rows, d.sampleType, second);
        const auto end = first.begin() + std::ptrdiff_t(rowBytes) * rows;
        const auto found = std::mismatch(first.begin(), end, second.begin()).first;
        if (found == end) continue;
        return "row " + std::to_string(row + (found - first.begin()) / std::ptrdiff_t(rowBytes));
    }
    return {};
}

}  // namespace

SecondReading compareReadings(const std::string& path) {
    const std::unique_ptr<ImageFile> ours = openPlain(path);
    if (!ours || ours->description().signs.model != ColorModel::rgb) return {};
    const std::unique_ptr<ImageFile> theirs = openImageIOParts(path).openImage(path, {});
    if (const char* what = differenceOf(ours->description(), theirs->description())) {
        return {true, what};
    }
    return {true, differentRow(*ours, *theirs)};
}

}  // namespace specbake
