#include "verify/largest_values.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace specbake::internal;

namespace {

/// The 99th percentile by its definition: place ⌈0.99 n⌉, from 1, of the ascending list.
double p99OfSorted(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto n = values.size();
    std::size_t place = 0;
    while (place * 100 < 99 * n) ++place;
    return values[place - 1];
}

}  // namespace

TEST_CASE("the 99th percentile is that of the sorted list, for any number and any size") {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> power(-12, 6);
    for (std::size_t n = 1; n < 1200; n += n < 210 ? 1 : 97) {
        CAPTURE(n);
        std::vector<double> values(n);
        // Half of them repeat, as the texels of a texture do.
        for (double& value : values) value = std::pow(10.0, std::round(power(engine) * 2) / 2);
        LargestValues largest(descendingRankOfP99(n));
        for (const double value : values) largest.add(value);
        REQUIRE(largest.ranked(descendingRankOfP99(n)) == p99OfSorted(values));
    }
}

TEST_CASE("where fewer came than were foreseen, the percentile is still that of the sorted list") {
    std::mt19937_64 engine(4);
    std::exponential_distribution<double> size(0.1);
    constexpr std::size_t foreseen = 5000;
    for (const std::size_t n : {1U, 99U, 100U, 101U, 1234U, 4999U}) {
        CAPTURE(n);
        LargestValues largest(descendingRankOfP99(foreseen));
        std::vector<double> values(n);
        for (double& value : values) largest.add(value = size(engine));
        CHECK(largest.ranked(descendingRankOfP99(n)) == p99OfSorted(values));
    }
}
