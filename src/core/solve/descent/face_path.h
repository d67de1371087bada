#pragma once

#include "solve/descent/decay.h"
#include "solve/face_modes.h"

#include <specbake/core/spectrum.h>

#include <optional>

namespace specbake::internal {

/// Where a path meets the boundary of the box.
struct Hit {
    std::size_t band = 0;
    double time = 0;
    double bound = 0;  ///< 0 or 1
};

/// The gradient flow of |W s - t|^2 / 2 within a face of the box, in closed form: (17)-(19) in
/// terms of the residual r = W s - t,
///
///     r(t)   = exp(-G t) r(0)
///     s_m(t) = s_m(0) - w_m . G^-1 (I - exp(-G t)) r(0)      for free m; the others rest.
///
/// It refers to its arguments and must not outlive them.
class FlowPath {
  public:
    FlowPath(const Weights& weights, const FreeSet& free, const Spectrum& start,
             const Imath::V3d& residual);

    /// The path has arrived: at 64 time constants of the slowest mode, exp(-64) = 2e-28 is left.
    double end() const { return end_; }
    /// The component as a function of time; `band` is free.
    Decay component(std::size_t band) const;
    double value(std::size_t band, double time) const { return component(band).value(time); }
    /// ds_m/dt at the start.
    double velocity(std::size_t band) const;
    /// The first component to leave [0, 1] before the end.
    std::optional<Hit> firstHit() const;

  private:
    /// A time at which a component is outside, so that the first hit is before it; else the end.
    double timeBeyondHit() const;

    const Weights& weights_;
    const FreeSet& free_;
    const Spectrum& start_;
    Imath::V3d residual_;
    Imath::V3d rates_;
    std::array<Imath::V3d, 3> modes_;  ///< q_k (q_k . r(0)) / rate_k
    double end_ = 0;
};

/// The straight line to the limit of the same flow, s_m(t) = s_m(0) - t w_m . G^-1 r(0), 0 <= t
/// <= 1.
class StraightPath {
  public:
    StraightPath(const Weights& weights, const FreeSet& free, const Spectrum& start,
                 const Imath::V3d& residual);

    double end() const { return 1; }
    double value(std::size_t band, double time) const;
    double velocity(std::size_t band) const { return -weights_[band].dot(direction_); }
    /// The ratio test.
    std::optional<Hit> firstHit() const;

  private:
    const Weights& weights_;
    const FreeSet& free_;
    const Spectrum& start_;
    Imath::V3d direction_;  ///< G^-1 r(0)
};

}  // namespace specbake::internal
