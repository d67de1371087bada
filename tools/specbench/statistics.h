#pragma once

#include <span>
#include <vector>

namespace specbake::bench {

/// The q-quantile, 0 <= q <= 1, by the nearest rank: the least value with at least the share q of
/// all at or below it. NaN for no values.
double quantile(std::vector<double> values, double q);
double median(std::vector<double> values);
double mean(std::span<const double> values);
double rootMeanSquare(std::span<const double> values);
double largest(std::span<const double> values);

}  // namespace specbake::bench
