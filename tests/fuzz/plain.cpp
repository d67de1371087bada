#include "target.h"
#include "texture/plain/plain_exr.h"
#include "texture/plain/plain_jpeg.h"
#include "texture/plain/plain_png.h"

#include <memory>
#include <vector>

namespace specbake::fuzz {
namespace {

/// Rows in an order that has readers begin anew, and once more as floats where that may be.
void readAll(internal::ImageFile& image) {
    const internal::ImageDescription& d = image.description();
    const auto read = [&](int first, int count, TexelType type) {
        std::vector<std::byte> rows(std::size_t(d.data.width) * d.channels.size() *
                                    bytesPerSample(type) * std::size_t(count));
        image.readRows(first, count, type, rows);
    };
    for (int row = 0; row < d.data.height; ++row) read(row, 1, d.sampleType);
    read(d.data.height / 2, 1, d.sampleType);
    if (!d.integers) read(0, 1, TexelType::float32);
}

}  // namespace

void run(std::span<const std::uint8_t> bytes) {
    const InputFile file(bytes);
    if (const auto png = internal::openPlainPng(file.path())) readAll(*png);
    if (const auto jpeg = internal::openPlainJpeg(file.path())) readAll(*jpeg);
    if (const auto exr = internal::openPlainExr(file.path())) readAll(*exr);
}

}  // namespace specbake::fuzz
