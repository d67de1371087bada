#pragma once

#include <specbake/core/observer.h>

#include <random>
#include <vector>

namespace specbake::testing {

/// Seeded colours of the kinds that a solver meets, for one observer.
class SampleColors {
  public:
    SampleColors(const Observer& observer, unsigned seed);

    /// Uniform in the cube [0, top]^3 of linear sRGB primaries.
    XYZ sRGB(double top = 1);
    /// On the rays from the solid's centre through points uniform in the solid, at this gauge:
    /// 1 is the boundary. By brute force over all pairs of weights.
    XYZ atGauge(double gauge);

  private:
    struct Face {
        Imath::V3d normal;
        double halfWidth;  ///< h(n) = sum |n . w_j| / 2
    };
    double gaugeOf(const Imath::V3d& offset) const;
    double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }

    Imath::V3d white_;
    Imath::M33d fromRGB_;
    std::vector<Face> faces_;
    std::mt19937_64 random_;
};

}  // namespace specbake::testing
