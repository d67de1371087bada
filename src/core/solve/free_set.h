#pragma once

#include <specbake/core/wavelengths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace specbake::internal {

/// The components of a spectrum that may still move, in ascending order. All of them at first.
class FreeSet {
  public:
    FreeSet() { std::iota(bands_.begin(), bands_.end(), std::size_t{0}); }

    std::size_t size() const { return count_; }
    auto begin() const { return bands_.begin(); }
    auto end() const { return bands_.begin() + std::ptrdiff_t(count_); }

    template <class Predicate>
    void removeIf(Predicate predicate) {
        const auto last =
            std::remove_if(bands_.begin(), bands_.begin() + std::ptrdiff_t(count_), predicate);
        count_ = std::size_t(last - bands_.begin());
    }

  private:
    std::array<std::size_t, kBandCount> bands_{};
    std::size_t count_ = kBandCount;
};

}  // namespace specbake::internal
