#pragma once

#include <Imath/ImathVec.h>

namespace specbake::internal {

/// A sum of vectors as the unrounded sum of two: what adding in the order of the calls gives, and
/// what it loses by rounding (A. Neumaier, ZAMM 54, 1974; the error term is D. E. Knuth's, TAOCP 2,
/// 4.2.2), itself rounded to 2^-53 of it.
class ExactSum {
  public:
    ExactSum() = default;
    explicit ExactSum(const Imath::V3d& first) : high_(first) {}

    void add(const Imath::V3d& term) {
        for (int i = 0; i < 3; ++i) {
            const double sum = high_[i] + term[i];
            const double part = sum - high_[i];
            low_[i] += (high_[i] - (sum - part)) + (term[i] - part);
            high_[i] = sum;
        }
    }
    void add(const ExactSum& other) {
        add(other.high_);
        add(other.low_);
    }
    void subtract(const ExactSum& other) {
        add(-other.high_);
        add(-other.low_);
    }

    /// The sum with a rounding at each step.
    const Imath::V3d& high() const { return high_; }
    /// The sum with one rounding.
    Imath::V3d rounded() const { return high_ + low_; }

  private:
    Imath::V3d high_{0.0};
    Imath::V3d low_{0.0};
};

}  // namespace specbake::internal
