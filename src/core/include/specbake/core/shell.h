#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/smooth.h>
#include <specbake/core/solid.h>
#include <specbake/core/solver.h>

namespace specbake {

/// The smooth solver, made to answer for every colour of the object-colour solid.
///
/// Newton's method is safe but for a thin layer under the solid's boundary. There, with r the gauge
/// of the colour t, t_b its boundary point and s_b that one's only spectrum (solid.h),
///
///     s = (d/D) s(t_0) + (1 - d/D) s_b,   d = 1 − r,   t_0 = c + (1 − D)(t_b − c)
///
/// which is exact as (1) is linear, bounded as (2) is convex, and continuous. The layer's depth D
/// follows the boundary point: by the mean tristimulus m of t_b beside white's,
///
///     D = δ · 4m(1 − m),   m = (X + Y + Z)(t_b) / (X + Y + Z)(white)
///
/// It vanishes at black and white, where greys meet the boundary and Newton is at its best: towards
/// black its problem only scales, and so does D, so that a colour's chromaticity decides whether it
/// is in the layer, however dark it is.
///
/// δ = 1/64 was found by measurement, over 4·10^5 colours at depths of 10^-4 to 10^-1 times
/// 4m(1 − m), one for each of E, A, D65, F11, half of them at the narrow ends of the solid: the
/// deepest failure of Newton's method was at 8·10^-4 (F11), a twentieth of δ. Of the surface of the
/// sRGB cube, dark colours included, the nearest to the boundary is at 0.040, so that sRGB never
/// meets the layer. Should Newton fail in spite of that, D is enlarged until it does not: on the
/// grey axis it cannot.
class ShellSolver : public Solver {
  public:
    explicit ShellSolver(const Observer& observer);

    /// `solved` for every colour of the solid, and for those that rounding alone puts outside
    /// (gauge at most 1 + 4 gaugeError(), what an 81-term sum or a matrix adds); residual <= 1e-11.
    /// `outside` for others: s is that of the boundary point towards the centre. `failed` only for
    /// colours that are not finite.
    Solution solve(const XYZ& color) const override;

    const Solid& solid() const { return solid_; }

    /// D of a boundary point, in units of the gauge.
    double depth(const XYZ& boundary) const;

  private:
    Solution blend(const XYZ& color) const;

    Observer observer_;
    Solid solid_;
    SmoothSolver smooth_;
};

}  // namespace specbake
