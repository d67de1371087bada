#pragma once

#include "solve/smooth.h"

#include <specbake/core/observer.h>
#include <specbake/core/solid.h>
#include <specbake/core/solver.h>

namespace specbake::internal {

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
/// δ = 1/256 was found by measurement (kRelativeDepth). Should Newton fail in spite of it, D is
/// doubled until it does not: on the grey axis it cannot.
class ShellSolver : public Solver {
  public:
    /// δ. Of 1.5·10^6 colours, over all illuminants, at depths of 2^-10 to 2^-4 times 4m(1 − m),
    /// half of them at the narrow ends of the solid, Newton failed on one: at 0.0032, within 10^-5
    /// of the white of F11. The next was at 0.0008, in another sample. The surface of the sRGB
    /// cube, dark colours included, is nowhere nearer than 0.040: sRGB never meets the layer. Under
    /// a thicker layer more colours have the boundary's steep spectra mixed in.
    static constexpr double kRelativeDepth = 1.0 / 256;

    /// `solid` is the observer's. 0 < relativeDepth <= 1, else throws ArgumentError.
    ShellSolver(const Observer& observer, const Solid& solid,
                double relativeDepth = kRelativeDepth);
    explicit ShellSolver(const Observer& observer, double relativeDepth = kRelativeDepth)
        : ShellSolver(observer, Solid(observer), relativeDepth) {}

    /// `solved` for every colour of the solid, and for those that rounding alone puts outside
    /// (gauge at most 1 + 4 gaugeError(), what an 81-term sum or a matrix adds); residual <= 1e-11.
    /// `outside` for others: s is that of the boundary point towards the centre. `failed` only for
    /// colours that are not finite.
    Solution solve(const XYZ& color) const override;
    void solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const override;

    const Solid& solid() const { return solid_; }

    /// D of a boundary point, in units of the gauge.
    double depth(const XYZ& boundary) const;

  private:
    struct Layered;
    void blend(std::span<const XYZ> colors, std::span<const std::size_t> places,
               std::span<Solution> solutions) const;
    Solution mixture(const XYZ& color, const Layered& c, const Spectrum& inner) const;

    double relativeDepth_;
    Observer observer_;
    Solid solid_;
    SmoothSolver smooth_;
};

}  // namespace specbake::internal
