#pragma once

#include <Imath/ImathVec.h>

#include <vector>

namespace specbake::internal {

/// One base of the object-colour solid: the planar zonogon of the generators with Z = 0.
///
/// Its inner points have many spectra. One is chosen that is continuous over the whole polygon and
/// meets the sides' spectra on its rim, where the spectrum is unique: with rho the gauge of the
/// polygon about its centre and s_e the spectrum of the rim point on the ray,
///
///     s = (1 - rho) 1/2 + rho s_e
class BasePolygon {
  public:
    BasePolygon() = default;

    /// Edge vectors by ascending angle, all within a half turn, x > 0. Of one edge it is a segment,
    /// of none a point.
    explicit BasePolygon(std::vector<Imath::V2d> edges);

    struct Point {
        std::vector<double> values;  ///< the spectrum, by edge
        double overshoot = 0;  ///< how far p was outside; the values are those of the rim then
    };

    /// The spectrum of a point given relative to the centre.
    Point at(const Imath::V2d& p) const;

  private:
    Point onSegment(const Imath::V2d& p) const;
    /// rho with the sign of the chain that the ray meets: + for the upper one.
    double signedGauge(const Imath::V2d& p) const;
    std::vector<double> upperChain(double x) const;

    std::vector<Imath::V2d> edges_;
    std::vector<Imath::V2d> normals_;  ///< over h(n): the rim is at 1
    Imath::V2d center_{0, 0};
};

}  // namespace specbake::internal
