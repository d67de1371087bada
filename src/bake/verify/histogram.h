#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <vector>

namespace specbake::internal {

/// How many differences fall where, so that a percentile needs no list of all texels.
class Histogram {
  public:
    void add(double value) {
        const double bin = std::min(std::ceil(value / kWidth), double(kBins - 1));
        count_[std::size_t(bin)].fetch_add(1, std::memory_order_relaxed);
    }
    /// The upper end of the bin in which that share of the values is reached.
    double percentile(double share, std::size_t total) const {
        std::size_t below = 0;
        for (std::size_t i = 0; i < kBins; ++i) {
            below += count_[i];
            if (double(below) >= share * double(total)) return double(i) * kWidth;
        }
        return 0;
    }

  private:
    static constexpr double kWidth = 1e-4;
    static constexpr std::size_t kBins = 200'000;  ///< beyond a difference of 20 none is told apart
    std::vector<std::atomic<std::size_t>> count_ = std::vector<std::atomic<std::size_t>>(kBins);
};

}  // namespace specbake::internal
