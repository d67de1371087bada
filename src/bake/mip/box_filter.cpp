#include "mip/box_filter.h"

#include <specbake/image/chunk_grid.h>

#include <algorithm>
#include <cstddef>

namespace specbake::internal {
namespace {

/// What one neighbour gives to each texel of the smaller row.
struct Neighbor {
    const TexelRow* row;
    std::size_t column;  ///< counted from the texel's first
    std::vector<double> share;
};

std::vector<Neighbor> neighborsByArea(std::span<const TexelRow* const> rows,
                                      const BoxTaps& vertical, int width, const Stretch& smaller) {
    std::vector<Neighbor> neighbors;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (int k = 0; k < boxTaps(width, 0).count; ++k) {
            Neighbor neighbor{rows[r], std::size_t(k), {}};
            for (int i = 0; i < smaller.count; ++i) {
                const double across = boxTaps(width, smaller.first + i).share[std::size_t(k)];
                neighbor.share.push_back(vertical.share[r] * across);
            }
            neighbors.push_back(std::move(neighbor));
        }
    }
    return neighbors;
}

/// The same by area times alpha, which is the rows' first channel.
std::vector<Neighbor> weighedByAlpha(std::vector<Neighbor> neighbors) {
    const std::size_t texels = neighbors.front().share.size();
    for (std::size_t i = 0; i < texels; ++i) {
        std::array<double, 9> seen{};
        double sum = 0;
        for (std::size_t n = 0; n < neighbors.size(); ++n) {
            const float alpha = (*neighbors[n].row)[2 * i + neighbors[n].column];
            seen[n] = neighbors[n].share[i] * double(std::clamp(alpha, 0.0F, 1.0F));
            sum += seen[n];
        }
        for (std::size_t n = 0; sum > 0 && n < neighbors.size(); ++n) {
            neighbors[n].share[i] = seen[n] / sum;
        }
    }
    return neighbors;
}

/// One channel, which begins at `from` in the rows. Sums are doubles: that they are rounded to
/// float but once is what keeps equal values equal.
void averageChannel(std::span<const Neighbor> neighbors, std::size_t from,
                    std::vector<double>& sums, std::span<float> to) {
    sums.assign(to.size(), 0.0);
    for (const Neighbor& neighbor : neighbors) {
        const float* values = neighbor.row->data() + from + neighbor.column;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += neighbor.share[i] * double(values[2 * i]);
        }
    }
    std::transform(sums.begin(), sums.end(), to.begin(), [](double sum) { return float(sum); });
}

}  // namespace

BoxTaps boxTaps(int side, int i) {
    if (side == 1) return {0, 1, {1}};
    if (side % 2 == 0) return {2 * i, 2, {0.5, 0.5}};
    const double n = side;
    const int m = halvedSide(side);
    return {2 * i, 3, {(m - i) / n, m / n, (i + 1) / n}};
}

Stretch sourceStretch(int width, const Stretch& smaller) {
    const BoxTaps first = boxTaps(width, smaller.first);
    const BoxTaps last = boxTaps(width, smaller.first + smaller.count - 1);
    return {first.first, last.first + last.count - first.first};
}

TexelRow averageRows(std::span<const TexelRow* const> rows, const BoxTaps& vertical, int width,
                     bool alpha) {
    return averageRows(rows, vertical, width, alpha, {0, halvedSide(width)});
}

TexelRow averageRows(std::span<const TexelRow* const> rows, const BoxTaps& vertical, int width,
                     bool alpha, const Stretch& smaller) {
    const auto source = std::size_t(sourceStretch(width, smaller).count);
    const std::size_t channels = rows.front()->size() / source;
    const auto count = std::size_t(smaller.count);
    const std::vector<Neighbor> byArea = neighborsByArea(rows, vertical, width, smaller);
    const std::vector<Neighbor> seen = alpha ? weighedByAlpha(byArea) : byArea;
    std::vector<double> sums;
    TexelRow averages(channels * count);
    for (std::size_t c = 0; c < channels; ++c) {
        averageChannel(alpha && c == 0 ? byArea : seen, c * source, sums,
                       std::span(averages).subspan(c * count, count));
    }
    return averages;
}

}  // namespace specbake::internal
