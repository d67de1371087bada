#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>
#include <specbake/core/observer.h>
#include <specbake/core/spectrum.h>

#include <memory>
#include <optional>

namespace specbake {

struct SolidMesh;

/// The object-colour solid of an observer: every colour that (2) allows, the Minkowski sum of the
/// segments [0, w_m] (paper, section 3). A convex zonohedron, symmetric about c = W·½: 5454
/// parallelograms on its side, and two bases of 48 sides at Z = 0 and Z = max.
///
/// Which vectors are parallel and on which side of a face a vector lies is decided exactly, on the
/// table's printed decimals. Colours are finite. Immutable: copies share one description, and so
/// may threads.
class SPECBAKE_API Solid {
  public:
    explicit Solid(const Observer& observer);

    const XYZ& white() const;
    XYZ center() const;

    /// r(t) = max over faces of |n·(t − c)| / h(n), h(n) = ½ Σ |n·w_j|: below 1 inside, 1 on the
    /// boundary, above 1 outside; linear along rays from the centre. About 1 µs.
    double gauge(const XYZ& color) const;

    /// The bound of |error of gauge(t)| / max(1, gauge(t)).
    ///
    /// With u = 2^-53, d = t − c and ρ the smallest h(n) of a unit normal (the inscribed sphere's
    /// radius): normals, h, their quotient, d, products and sums add 8 roundings to each
    /// |n_i d_i| / h, so 8u |d|/ρ; the products n·w_j in h, 3u Σ|w_j|/2 < 6u |c|; c is a sum of 81
    /// terms, so 81u |c|/ρ. |d| <= r |c|.
    double gaugeError() const;

    /// Whether a colour lies in the solid, its boundary included: to the gauge's rounding, so that
    /// black and white are inside.
    bool contains(const XYZ& color) const { return gauge(color) <= 1 + gaugeError(); }

    /// p(t) of (M15): in the cone of the chromaticities that reflectances have, t/p(t) is where the
    /// ray from black through t leaves the solid. Convex, and p(kt) = k p(t) for k >= 0. Some 4 µs.
    double gaugeFromBlack(const XYZ& color) const;

    /// δ(t) of (M16): the sine of the angle from t to the nearest face plane of that cone; positive
    /// inside, 0 on its edge, negative outside. t is not black.
    double depthInCone(const XYZ& color) const;

    /// Where the ray from the centre through a colour leaves the solid.
    struct Boundary {
        double gauge = 0;
        XYZ color;            ///< t_b = c + (t − c)/r; the centre itself if t is the centre
        Spectrum spectrum{};  ///< of t_b; ½ for the centre
    };

    /// The spectrum is (13), the only one that t_b has; inside the two bases, where there are many,
    /// it is a continuous choice that meets (13) on their rims. Continuous in t except at the
    /// centre. |W s − t_b| is of the order of rounding; black and white get 0 and 1 exactly.
    Boundary boundary(const XYZ& color) const;

    struct Nearest {
        XYZ color;                         ///< the point of the solid nearest to t, in XYZ
        double distance = 0;               ///< Euclidean
        std::optional<Spectrum> spectrum;  ///< as in Boundary; none if t is in the solid
    };

    /// The paper's rule for colours outside (its section 4). A colour inside is its own nearest.
    Nearest nearest(const XYZ& color) const;

    /// Σ max(0, direction·w_j): the largest direction·q of any q in the solid.
    double support(const Imath::V3d& direction) const;

    /// Σ |det(w_i, w_j, w_k)| over the triples of generators.
    double volume() const;

  private:
    struct SPECBAKE_LOCAL Data;
    std::shared_ptr<const Data> data_;
    friend SPECBAKE_API SolidMesh solidMesh(const Solid& solid);
};

}  // namespace specbake
