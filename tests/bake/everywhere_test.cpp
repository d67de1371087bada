#include "support/each_target.h"

#include <specbake/bake/bake.h>
#include <specbake/image/memory_texture.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <random>
#include <vector>

using namespace specbake;

namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 19;

/// RGB of seeded texels, some of them outside the solid's reach by grids, some greys, some black.
std::vector<float> texels() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> values(std::size_t(kWidth) * kHeight * 3);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        const float grey = uniform(random);
        for (std::size_t c = 0; c < 3; ++c) {
            values[i + c] = i % 15 == 0 ? grey : i % 21 == 0 ? 0.0F : uniform(random);
        }
    }
    return values;
}

/// All samples of a bake in memory, as floats.
std::vector<float> baked(const std::vector<float>& values, const BakeOptions& options) {
    MemoryImage image;
    image.width = kWidth;
    image.height = kHeight;
    image.channels = 3;
    image.samples = std::as_bytes(std::span(values));
    MemoryTexture texture(image);
    std::vector<float> samples;
    const auto take = [&](int /*row*/, std::span<const std::byte> row) {
        const std::size_t before = samples.size();
        samples.resize(before + row.size() / sizeof(float));
        std::memcpy(samples.data() + before, row.data(), row.size());
    };
    bake(texture, {{}, take}, options);
    return samples;
}

BakeOptions optionsOf(const char* method, bool grid, int threads) {
    BakeOptions options;
    options.model.method = method;
    if (!grid) options.model.grid = std::nullopt;
    options.storage.sampleType = SampleType::float32;
    options.threads = threads;
    return options;
}

/// Whether products and sums are fused in the instruction set under test.
bool isFused() {
    constexpr std::int64_t unfused = HWY_SSSE3 | HWY_SSE4 | HWY_EMU128 | HWY_SCALAR;
    return (hwy::SupportedTargets() & ~unfused) != 0;
}

/// Calls `test` with each of two methods, through the grid and without.
template <class Test>
void onEachModel(const Test& test) {
    for (const char* method : {"natural", "smooth"}) {
        for (const bool grid : {true, false}) {
            CAPTURE(method);
            CAPTURE(grid);
            test(method, grid);
        }
    }
}

}  // namespace

TEST_CASE("samples are the same to the last bit with any threads and fused instruction set") {
    const std::vector<float> values = texels();
    onEachModel([&](const char* method, bool grid) {
        std::vector<float> first;
        onEachTarget([&] {
            if (!isFused()) return;
            for (const int threads : {1, 2, 3, 8, 64}) {
                CAPTURE(threads);
                const std::vector<float> samples = baked(values, optionsOf(method, grid, threads));
                if (first.empty()) first = samples;
                CHECK(samples == first);
            }
        });
    });
}

TEST_CASE("without fused multiply-adds samples are as near as float tells") {
    const std::vector<float> values = texels();
    onEachModel([&](const char* method, bool grid) {
        const std::vector<float> here = baked(values, optionsOf(method, grid, 1));
        onEachTarget([&] {
            if (isFused()) return;
            const std::vector<float> samples = baked(values, optionsOf(method, grid, 1));
            CHECK(samples == baked(values, optionsOf(method, grid, 8)));
            float largest = 0;
            for (std::size_t i = 0; i < here.size(); ++i) {
                largest = std::max(largest, std::abs(samples[i] - here[i]));
            }
            // A sample is three products and sums of values up to 1: where they are not fused,
            // three roundings more, of half a unit in the last place each.
            CHECK(largest <= 3 * std::ldexp(1.0F, -24));
        });
    });
}
