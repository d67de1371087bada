#pragma once

#include <specbake/core/observer.h>

#include <Imath/ImathMatrix.h>

#include <array>

namespace specbake::internal {

/// The first Newton step of (M6), from the grey of a colour's luminance: there z is flat, s' is the
/// same in all bands, and no multiplier pulls, so that the matrix is always
///
///     | K  Wᵀ |   with the unknowns z and s' λ, and the right side 0, (W s − t)/s'.
///     | W  0  |
///
/// The step is linear in the right side and costs 81 products of three.
class FirstStep {
  public:
    explicit FirstStep(const Observer& observer);

    struct Point {
        std::array<double, kBandCount> z;
        Imath::V3d multipliers;
    };
    /// Where the step leads, damped as all steps are. `color` is no grey.
    Point from(const XYZ& color) const;

  private:
    Imath::V3d white_;
    std::array<Imath::V3d, kBandCount> z_;  ///< the change of z for a right side
    Imath::M33d multipliers_;               ///< of s' λ: right side * multipliers_
};

}  // namespace specbake::internal
