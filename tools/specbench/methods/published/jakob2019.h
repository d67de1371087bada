#pragma once

#include "methods/method.h"

#include <array>

namespace specbake::bench {

/// W. Jakob, J. Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling",
/// Computer Graphics Forum 38(2) (Eurographics), 2019:
///
///     s(λ) = S(c_0 u² + c_1 u + c_2),   S(x) = ½ + x / (2 sqrt(1 + x²)),
///
/// with u = (λ − 380) / 400 nm. Always bounded and smooth; three coefficients a colour.
///
/// | quantity     | domain       | scale                                        |
/// |--------------|--------------|----------------------------------------------|
/// | XYZ          | the solid    | Y of white = 1                               |
/// | spectrum     | (0, 1)       | 1 = perfect reflector; white only in a limit |
/// | coefficients | any          |                                              |
///
/// What the authors' program of 2026 does is done here too: Levenberg-Marquardt instead of the
/// paper's Gauss-Newton, no limit of coefficients, and greys in closed form.
using SigmoidCoefficients = std::array<double, 3>;

/// The x with S(x) = y; ±8192 at 0 and 1, where S is 0 and 1 to a float.
double sigmoidInverse(double y);

Spectrum sigmoidSpectrum(const SigmoidCoefficients& c);

struct SigmoidFit {
    SigmoidCoefficients coefficients{};
    double labError = 0;  ///< CIE 1976 difference left, the quantity minimised
    int iterations = 0;
};

/// The coefficients whose colour is nearest to `color` in CIELAB: Gauss-Newton steps, damped where
/// they do not improve (Levenberg-Marquardt), from `start`.
SigmoidFit fitSigmoid(const XYZ& color, const Observer& observer,
                      const SigmoidCoefficients& start = {});

/// One fit a colour, from the spectrum ½ as the authors start; where that does not arrive (faint
/// saturated colours are far from it), from the grey of the same luminance.
class Jakob2019Direct : public Method {
  public:
    explicit Jakob2019Direct(Frame frame)
        : Method({"Jakob & Hanika 2019", "direct"}, std::move(frame)) {}
    /// Says that it did not converge where a CIELAB difference of more than 1 is left.
    Reconstruction reconstruct(const XYZ& color) const override;
};

}  // namespace specbake::bench
