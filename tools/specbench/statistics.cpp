#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace specbake::bench {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

double quantile(std::vector<double> values, double q) {
    if (values.empty()) return kNothing;
    const double rank = std::ceil(q * double(values.size()));
    const auto at = std::ptrdiff_t(std::clamp(rank - 1, 0.0, double(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[std::size_t(at)];
}

double median(std::vector<double> values) {
    return quantile(std::move(values), 0.5);
}

double mean(std::span<const double> values) {
    if (values.empty()) return kNothing;
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double rootMeanSquare(std::span<const double> values) {
    double sum = 0;
    for (const double v : values) sum += v * v;
    return values.empty() ? kNothing : std::sqrt(sum / double(values.size()));
}

double largest(std::span<const double> values) {
    return values.empty() ? kNothing : *std::ranges::max_element(values);
}

}  // namespace specbake::bench
