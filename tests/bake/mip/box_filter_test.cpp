#include "mip/box_filter.h"

#include "mip/pyramid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace specbake;
using namespace specbake::internal;

namespace {

/// Averages of a row of one channel, alone or under a row of alpha.
TexelRow averaged(const TexelRow& row, int width, bool alpha = false) {
    const TexelRow* rows[] = {&row};
    return averageRows(rows, boxTaps(1, 0), width, alpha);
}

}  // namespace

TEST_CASE("a texel takes its neighbours by the length that it covers of them") {
    for (const int n : {1, 2, 3, 4, 5, 16, 17, 37, 1000, 1001}) {
        CAPTURE(n);
        const int m = halvedSide(n);
        const double covered = double(n) / m;
        std::vector<double> taken(std::size_t(n), 0.0);
        for (int i = 0; i < m; ++i) {
            const BoxTaps taps = boxTaps(n, i);
            double whole = 0;
            for (int k = 0; k < taps.count; ++k) {
                const int x = taps.first + k;
                const double overlap =
                    std::min(x + 1.0, (i + 1) * covered) - std::max(double(x), i * covered);
                const double share = taps.share[std::size_t(k)];
                // Quotients of integers up to 1001 and their differences: a few 2^-53 of 1001.
                CHECK(std::abs(share - overlap / covered) < 1e-12);
                whole += share;
                taken.at(std::size_t(x)) += share;
            }
            CHECK(std::abs(whole - 1) < 4 * 0x1p-53);
        }
        for (const double share : taken) CHECK(std::abs(share - double(m) / n) < 4 * 0x1p-53);
    }
}

TEST_CASE("equal values stay equal to the last bit, and averages stay between values") {
    std::mt19937 random(3);
    for (const int width : {2, 3, 17, 37, 38}) {
        const float value = float(random()) * 0x1p-32F;
        const TexelRow equal(std::size_t(width), value);
        for (const float average : averaged(equal, width)) CHECK(average == value);
        TexelRow mixed(std::size_t(2 * width));
        for (float& v : mixed) v = random() % 2 == 0 ? value : std::nextafter(value, 1.0F);
        for (const float average : averaged(mixed, width, true)) {
            CHECK(average >= value);
            CHECK(average <= std::nextafter(value, 1.0F));
        }
    }
}

TEST_CASE("alpha weighs the other channels, and nothing is seen of what is transparent") {
    // alpha, then one channel
    CHECK(averaged({1.0F, 0.0F, 0.25F, 1.0F}, 2, true) == TexelRow{0.5F, 0.25F});
    CHECK(averaged({0.75F, 0.25F, 0.0F, 1.0F}, 2, true) == TexelRow{0.5F, 0.25F});
    CHECK(averaged({0.0F, 0.0F, 0.25F, 0.75F}, 2, true) == TexelRow{0.0F, 0.5F});
    CHECK(averaged({0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.5F}, 3, true).back() == 0.5F);
    // Beyond 0 to 1, alpha counts as the nearer of these; the least there is does count.
    CHECK(averaged({2.0F, -1.0F, 0.25F, 0.75F}, 2, true) == TexelRow{0.5F, 0.25F});
    CHECK(averaged({0x1p-149F, 0.0F, 0.25F, 0.75F}, 2, true).back() == 0.25F);
}

TEST_CASE("a pyramid's levels have the mean of the rows that it was given") {
    const int width = 13;
    const int height = 27;
    const StorageOptions storage{SampleType::half, Compression::zip, 3, TileSize{4, 5}, true};
    const std::vector<ChunkGrid> levels = chunkGrids(width, height, storage);
    REQUIRE(levels.size() == 5);
    Pyramid pyramid(levels, false);
    std::mt19937 random(4);
    std::vector<double> sums(levels.size());
    std::vector<int> rows(levels.size());
    for (int y = 0; y < height; ++y) {
        TexelRow row(std::size_t(width), 0.0F);
        for (float& v : row) v = float(random() % 1000) / 1000;
        pyramid.add(row);
        for (const TileRow& tiles : pyramid.takeComplete()) {
            const auto level = std::size_t(tiles.level);
            CHECK(tiles.row * 5 == rows[level]);
            rows[level] += int(tiles.texels.size());
            for (const auto& texels : tiles.texels) {
                CHECK(int(texels->size()) == levels[level].width);
                for (const float v : *texels) sums[level] += double(v);
            }
        }
    }
    for (std::size_t l = 0; l < levels.size(); ++l) {
        CHECK(rows[l] == levels[l].height);
        const double mean = sums[l] / (levels[l].width * levels[l].height);
        // Each level rounds values below 1 to float: by 2^-25 at most.
        CHECK(std::abs(mean - sums[0] / (width * height)) < double(l + 1) * 0x1p-25);
    }
}
