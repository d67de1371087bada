#pragma once

#include "solid/face_levels.h"
#include "solid/generators.h"

#include <Imath/ImathVec.h>

#include <vector>

namespace specbake::internal {

/// The solid as it is seen from black, its vertex at 0.
///
/// Faces that pass through black bound the cone of the colours that some brightness brings into the
/// solid; which do is decided exactly. The others, n·x <= H, are what a ray from black can meet.
class FromBlack {
  public:
    FromBlack() = default;

    /// `vectors`: of the generators, under a light; those without light make no face.
    FromBlack(const Generators& generators, const std::vector<Imath::V3d>& vectors);

    /// (M15): max n·t / H over the faces that do not pass through black, at least 0.
    double gauge(const Imath::V3d& t) const;

    /// (M16): min −n·t / |t| over those that do; t is not 0.
    double depth(const Imath::V3d& t) const;

  private:
    std::vector<Imath::V3d> cone_;  ///< outward unit normals
    FaceLevels caps_;               ///< n / H
};

}  // namespace specbake::internal
