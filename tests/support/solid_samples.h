#pragma once

#include <specbake/core/solid.h>

#include <algorithm>
#include <cmath>
#include <random>

/// Colours in, on and about the object-colour solid, and what rounding does to them.
namespace specbake::testing {

inline constexpr double kUnit = 0x1p-53;  // half of the spacing of doubles at 1

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    /// In the box of the solid, widened on each side by `margin` of its size.
    XYZ inBox(const Solid& solid, double margin) {
        const XYZ w = solid.white();
        const auto part = [&] { return (*this)(-margin, 1 + margin); };
        return {w.x * part(), w.y * part(), w.z * part()};
    }
    Imath::V3d direction() {
        std::normal_distribution<double> normal;
        return Imath::V3d(normal(engine_), normal(engine_), normal(engine_)).normalized();
    }
    /// On the boundary: by direction from the centre, or, every other time, in a base: a sliver
    /// that no random direction meets.
    XYZ onBoundary(const Observer& observer, const Solid& solid) {
        if ((*this)(0, 2) < 1) return inBase(observer);
        const Imath::V3d d = direction();
        return XYZ(solid.center() + d / solid.gauge(XYZ(solid.center() + d)));
    }
    XYZ inBase(const Observer& observer) {
        const double blue = std::round((*this)(0, 1));
        const double steepness = (*this)(0, 1) < 0.5 ? 1 : 10;  // 10: most values 0 or 1
        Spectrum s;
        for (std::size_t m = 0; m < s.size(); ++m) {
            const double red = std::clamp(0.5 + steepness * (*this)(-0.5, 0.5), 0.0, 1.0);
            s[m] = observer.weights()[m].z == 0 ? red : blue;
        }
        return observer.color(s);
    }

  private:
    std::mt19937_64 engine_;
};

/// The rounding of an 81-term sum W s.
inline double sumRounding(const Solid& solid) {
    return 81 * kUnit * (solid.white().x + solid.white().y + solid.white().z);
}

inline bool withinBounds(const Spectrum& s) {
    return std::all_of(s.begin(), s.end(), [](double v) { return v >= 0 && v <= 1; });
}

}  // namespace specbake::testing
