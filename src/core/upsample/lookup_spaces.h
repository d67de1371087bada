#pragma once

#include <specbake/core/color.h>

#include <Imath/ImathMatrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace specbake::internal {

/// Where texels stand: the linear space of the texture, and the cube that the grid divides.
class LookupSpaces {
  public:
    using Color = std::array<float, 3>;

    /// A texel's colour is XYZ(texel * xyzFromTexel), that of a point of the cube likewise.
    LookupSpaces(const Imath::M33d& xyzFromTexel, const Imath::M33d& xyzFromGrid)
        : xyzFromTexel_(xyzFromTexel), xyzFromGrid_(xyzFromGrid) {
        if (xyzFromTexel != xyzFromGrid) gridFromTexel_ = xyzFromTexel * xyzFromGrid.inverse();
    }

    const Imath::M33d& xyzFromTexel() const { return xyzFromTexel_; }
    const Imath::M33d& xyzFromGrid() const { return xyzFromGrid_; }

    XYZ xyzOfTexel(const Color& texel) const { return XYZ(asDoubles(texel) * xyzFromTexel_); }
    XYZ xyzOfPoint(const Color& point) const { return XYZ(asDoubles(point) * xyzFromGrid_); }

    /// The point of the cube, or beyond it, where a texel stands.
    Color gridPoint(const Color& texel) const {
        if (!gridFromTexel_) return texel;
        const Imath::V3d point = asDoubles(texel) * *gridFromTexel_;
        return {float(point.x), float(point.y), float(point.z)};
    }

  private:
    static Imath::V3d asDoubles(const Color& color) {
        return {double(color[0]), double(color[1]), double(color[2])};
    }

    Imath::M33d xyzFromTexel_;
    Imath::M33d xyzFromGrid_;
    std::optional<Imath::M33d> gridFromTexel_;  ///< none: they are the same
};

inline bool isInUnitCube(const LookupSpaces::Color& point) {
    bool inside = true;
    for (const float v : point) inside = inside & (v >= 0) & (v <= 1);
    return inside;
}

inline bool isFinite(const LookupSpaces::Color& color) {
    return std::all_of(color.begin(), color.end(), [](float v) { return std::isfinite(v); });
}

}  // namespace specbake::internal
