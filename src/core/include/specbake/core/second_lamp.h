#pragma once

#include <specbake/core/api.h>
#include <specbake/core/observer.h>
#include <specbake/core/spectrum.h>

#include <memory>

namespace specbake {

/// A reflectance moved until it has a given colour under a second light too, and keeps its own
/// under the first.
///
/// With s = ½ (1 + tanh z) as in (M3) and the six equations W₁ s = t₁, W₂ s = t₂ together as
/// W s = t, every step is the smoothest change of z that meets them to first order,
///
///     z ← z − M Jᵀ (J M Jᵀ)⁻¹ (W s(z) − t),   J = columns s'_m w_m,   M = (K + ε I)⁻¹   (M19)
///
/// K being the second-difference matrix of (M5); s stays within (0, 1). Where no reflectance has
/// both colours, the first is kept, and the second is the nearest, in XYZ, that a reflectance with
/// the first can have (M20, docs/method.md). Immutable: any number of threads may share it.
class SPECBAKE_API SecondLamp {
  public:
    SecondLamp(const Observer& first, const Observer& second);

    struct Answer {
        Spectrum spectrum{};
        bool met = false;  ///< whether it has the second colour, each of XYZ to 1e-7
    };
    /// What floats resolve of a colour: a pair at the edge of the possible is off by as much. Other
    /// pairs are met to 1e-12.
    static constexpr double kNearTolerance = 1e-7;

    /// `base` in [0, 1]; the first colour stays to 1e-12. White and black stay as they are.
    Answer move(const Spectrum& base, const XYZ& second) const;

    const Observer& second() const { return second_; }

  private:
    struct Weights;

    Observer second_;
    std::shared_ptr<const Weights> weights_;
};

}  // namespace specbake
