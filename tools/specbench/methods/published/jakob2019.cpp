#include "methods/published/jakob2019.h"

#include <Imath/ImathMatrix.h>

#include <algorithm>
#include <cmath>

namespace specbake::bench {
namespace {

constexpr double kSolved = 1e-9;  // CIELAB difference
constexpr int kMaxIterations = 100;

double bandPosition(std::size_t band) {
    return double(band) / (kBandCount - 1);
}

double polynomial(const SigmoidCoefficients& c, double u) {
    return (c[0] * u + c[1]) * u + c[2];
}

double sigmoid(double x) {
    return 0.5 + 0.5 * x / std::sqrt(1 + x * x);
}

/// S'(x) = ½ (1 + x²)^(−3/2)
double sigmoidSlope(double x) {
    const double q = 1 / (1 + x * x);
    return 0.5 * q * std::sqrt(q);
}

/// Derivative of the response f of CIELAB (CIE 15, (8.7)).
double labSlope(double ratio) {
    constexpr double delta = 6.0 / 29.0;
    return ratio > delta * delta * delta ? 1 / (3 * std::cbrt(ratio * ratio))
                                         : 1 / (3 * delta * delta);
}

Imath::V3d asVector(const Lab& lab) {
    return {lab.L, lab.a, lab.b};
}

/// A trial point: its difference to the target, and the derivative of that.
struct Trial {
    SigmoidCoefficients coefficients;
    Imath::V3d residual;   ///< Lab − target Lab
    Imath::M33d jacobian;  ///< [k][j]: d residual_j / d c_k, for row vectors
};

/// d(L, a, b) / d(X, Y, Z) as a matrix for row vectors: [i][j] = d Lab_j / d XYZ_i.
Imath::M33d labDerivative(const XYZ& color, const XYZ& white) {
    const double dx = labSlope(color.x / white.x) / white.x;
    const double dy = labSlope(color.y / white.y) / white.y;
    const double dz = labSlope(color.z / white.z) / white.z;
    return {0, 500 * dx, 0, 116 * dy, -500 * dy, 200 * dy, 0, 0, -200 * dz};
}

Trial evaluate(const SigmoidCoefficients& c, const Lab& target, const Observer& observer) {
    Imath::V3d color(0.0), slopes[3] = {color, color, color};
    for (std::size_t m = 0; m < kBandCount; ++m) {
        const double u = bandPosition(m);
        const double x = polynomial(c, u);
        const Imath::V3d& w = observer.weights()[m];
        const Imath::V3d slope = w * sigmoidSlope(x);
        color += w * sigmoid(x);
        slopes[0] += slope * (u * u);
        slopes[1] += slope * u;
        slopes[2] += slope;
    }
    Imath::M33d colorDerivative;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) colorDerivative[k][i] = slopes[k][i];
    }
    const XYZ& white = observer.white();
    return {c, asVector(labFromXYZ(XYZ(color), white)) - asVector(target),
            colorDerivative * labDerivative(XYZ(color), white)};
}

/// −(J Jᵀ + damping 1)⁻¹ J r added to the coefficients; J as rows of parameters. The damping of the
/// unit matrix, not of the diagonal, keeps coefficients from running away where a spectrum is
/// nearly 0 or 1 and its colour hardly depends on them.
SigmoidCoefficients stepped(const Trial& at, double damping) {
    Imath::M33d normal = at.jacobian * at.jacobian.transposed();
    for (int k = 0; k < 3; ++k) normal[k][k] += damping;
    const Imath::V3d gradient = at.residual * at.jacobian.transposed();
    const Imath::V3d step = gradient * normal.inverse();
    return {at.coefficients[0] - step.x, at.coefficients[1] - step.y, at.coefficients[2] - step.z};
}

}  // namespace

double sigmoidInverse(double y) {
    constexpr double least = 4e-9;  // S(-8192)
    const double s = std::clamp(y, least, 1 - least);
    return (s - 0.5) / std::sqrt(s * (1 - s));
}

Spectrum sigmoidSpectrum(const SigmoidCoefficients& c) {
    Spectrum s;
    for (std::size_t m = 0; m < s.size(); ++m) s[m] = sigmoid(polynomial(c, bandPosition(m)));
    return s;
}

SigmoidFit fitSigmoid(const XYZ& color, const Observer& observer,
                      const SigmoidCoefficients& start) {
    constexpr double firstDamping = 1e-6, leastDamping = 1e-14, hopeless = 1e8;
    const Lab target = labFromXYZ(color, observer.white());
    Trial best = evaluate(start, target, observer);
    double damping = firstDamping;
    int i = 0;
    for (; i < kMaxIterations && best.residual.length() > kSolved && damping < hopeless; ++i) {
        const Trial trial = evaluate(stepped(best, damping), target, observer);
        if (trial.residual.length2() < best.residual.length2()) {
            best = trial;
            damping = std::max(leastDamping, damping * 0.1);
        } else {
            damping *= 10;
        }
    }
    return {best.coefficients, best.residual.length(), i};
}

Reconstruction Jakob2019Direct::reconstruct(const XYZ& color) const {
    constexpr double visible = 1;
    constexpr double arrived = 1e-3;
    SigmoidFit fit = fitSigmoid(color, frame().observer);
    if (fit.labError > arrived) {
        const SigmoidFit other =
            fitSigmoid(color, frame().observer, {0, 0, sigmoidInverse(color.y)});
        if (other.labError < fit.labError) fit = other;
    }
    return {sigmoidSpectrum(fit.coefficients), fit.labError <= visible};
}

}  // namespace specbake::bench
