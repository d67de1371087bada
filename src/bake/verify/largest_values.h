#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace specbake::internal {

/// The largest `count` of many values, in memory for twice as many. What it answers does not depend
/// on the order in which they come.
class LargestValues {
  public:
    explicit LargestValues(std::size_t count) : count_(count) {}

    void add(double value) {
        if (shrunk_ && value <= least_) return;
        values_.push_back(value);
        if (values_.size() >= 2 * count_) shrink();
    }

    /// The rank-th largest of all that was added, from 1; rank <= count, and not beyond what was
    /// added.
    double ranked(std::size_t rank) {
        select(rank);
        return values_[rank - 1];
    }

  private:
    void select(std::size_t rank) {
        std::nth_element(values_.begin(), values_.begin() + std::ptrdiff_t(rank - 1), values_.end(),
                         std::greater<>());
    }
    void shrink() {
        select(count_);
        values_.resize(count_);
        least_ = values_.back();
        shrunk_ = true;
    }

    std::size_t count_;
    std::vector<double> values_;
    double least_ = 0;  ///< of the values kept, once some were forgotten
    bool shrunk_ = false;
};

/// By the nearest-rank definition the 99th percentile of n values is the one at place ⌈0.99 n⌉ of
/// the ascending list: this is its place, from 1, in the descending one.
constexpr std::size_t descendingRankOfP99(std::size_t n) {
    return n - (99 * n + 99) / 100 + 1;
}

}  // namespace specbake::internal
