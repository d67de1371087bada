#pragma once

#include "solid/base_polygon.h"
#include "solid/exact_sum.h"
#include "solid/face_levels.h"
#include "solid/from_black.h"
#include "solid/generators.h"
#include "solid/on_first_use.h"
#include "solid/release_rates.h"

#include <specbake/core/solid.h>

#include <array>
#include <memory>
#include <vector>

namespace specbake::internal {

/// s by generator; all bands of a generator share its value.
using GeneratorValues = std::array<double, kBandCount>;

/// W s
Imath::V3d colorOf(const std::vector<Imath::V3d>& vectors, const GeneratorValues& values);

/// A vertex of the solid, and the exact way from it to a colour.
struct Vertex {
    GeneratorSet ones;
    ExactSum gap;
};

/// 1 − s, the spectrum of the point opposite.
GeneratorValues opposite(const GeneratorValues& values);

}  // namespace specbake::internal

namespace specbake {

/// What every part of the solid shares.
struct Solid::Data {
    explicit Data(const Observer& observer);

    std::shared_ptr<const internal::Generators> generators;
    XYZ white;
    XYZ center;
    std::vector<Imath::V3d> vectors;  ///< the generators, each the sum of its bands' w_m
    internal::ReleaseRates rates;     ///< of `vectors`
    internal::BasePolygon base;
    Imath::V2d topCenter;  ///< of the base at Z = max, in XY

    /// The outward normals with n_Z > 0, over h(n): those of generators->sides, then the base's.
    /// The solid's symmetry gives the other half.
    internal::FaceLevels faces;
    double gaugeError = 0;

    /// Made when a colour is beyond the boundary: few textures have any.
    const internal::FromBlack& fromBlack() const;

    /// Values whose colour is a boundary point's, and how far their colour is from it.
    struct FacePoint {
        internal::GeneratorValues values{};
        double error = 0;
    };
    FacePoint onBoundary(const XYZ& boundary) const;

    /// Bands that weigh nothing repeat the one before, or the first that does not.
    Spectrum expand(const internal::GeneratorValues& values) const;

    /// The chosen values of a point of the base at Z = max.
    FacePoint onTopBase(const XYZ& point) const;
    /// Of a point of one of generators->sides.
    FacePoint onSide(std::size_t face, const XYZ& point) const;

    /// The corner of each of generators->sides at which its two generators are 0. Made when a
    /// colour is at the boundary or beyond it.
    const std::vector<internal::ExactSum>& corners() const;
    internal::ExactSum all;  ///< Σ w_j

    /// A vertex of the solid from which the nearest point to a colour outside is not far.
    internal::Vertex near(const XYZ& color, double gauge) const;

  private:
    internal::ExactSum sumOf(const internal::GeneratorSet& set) const;
    internal::Vertex corner(std::size_t face, bool otherSide, const XYZ& color) const;
    void makeFaces();

    internal::OnFirstUse<internal::FromBlack> fromBlack_;
    internal::OnFirstUse<std::vector<internal::ExactSum>> corners_;
};

}  // namespace specbake
