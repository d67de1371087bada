#include <specbake/core/error.h>
#include <specbake/image/memory_texture.h>

#include <doctest/doctest.h>

#include <numeric>

using namespace specbake;

namespace {

/// Bytes 0, 1, 2, …
std::vector<std::byte> counting(std::size_t count) {
    std::vector<std::byte> bytes(count);
    for (std::size_t i = 0; i < count; ++i) bytes[i] = std::byte(i);
    return bytes;
}

MemoryImage image(std::span<const std::byte> samples) {
    MemoryImage i;
    i.width = 3;
    i.height = 4;
    i.channels = 4;
    i.alpha = 3;
    i.sampleType = TexelType::uint8;
    i.samples = samples;
    return i;
}

}  // namespace

TEST_CASE("rows of an array are its bytes, whatever stands between them") {
    const auto bytes = counting(200);
    for (const std::size_t stride : {std::size_t(0), std::size_t(12), std::size_t(17)}) {
        MemoryImage i = image(bytes);
        i.rowStride = stride;
        MemoryTexture texture(i);
        std::vector<std::byte> rows(24);
        texture.readRows(2, 2, rows);
        const std::size_t step = stride == 0 ? 12 : stride;
        for (std::size_t b = 0; b < 12; ++b) {
            CHECK(rows[b] == bytes[2 * step + b]);
            CHECK(rows[12 + b] == bytes[3 * step + b]);
        }
    }
}

TEST_CASE("an array that cannot be an image is refused") {
    const auto bytes = counting(47 + 1);
    CHECK_NOTHROW(MemoryTexture(image(bytes)));
    const auto refused = [&bytes](auto change) {
        MemoryImage i = image(bytes);
        change(i);
        CHECK_THROWS_AS(MemoryTexture{i}, ArgumentError);
    };
    refused([](MemoryImage& i) { i.samples = i.samples.first(47); });
    refused([](MemoryImage& i) { i.width = 0; });
    refused([](MemoryImage& i) { i.height = -1; });
    refused([](MemoryImage& i) { i.width = kLargestSide + 1; });
    refused([](MemoryImage& i) { i.channels = 5; });
    refused([](MemoryImage& i) { i.channels = 2, i.alpha = std::nullopt; });
    refused([](MemoryImage& i) { i.alpha = 4; });
    refused([](MemoryImage& i) { i.alpha = -1; });
    refused([](MemoryImage& i) { i.rowStride = 11; });
    refused([](MemoryImage& i) { i.rowStride = 13; });
    refused([](MemoryImage& i) { i.sampleType = TexelType::half; });
}

TEST_CASE("rows that are not there, and buffers too small, are refused") {
    const auto bytes = counting(48);
    MemoryTexture texture(image(bytes));
    std::vector<std::byte> rows(48);
    CHECK_THROWS_AS(texture.readRows(-1, 1, rows), ArgumentError);
    CHECK_THROWS_AS(texture.readRows(3, 2, rows), ArgumentError);
    CHECK_THROWS_AS(texture.readRows(0, 4, std::span(rows).first(47)), ArgumentError);
    CHECK_NOTHROW(texture.readRows(0, 4, rows));
}
