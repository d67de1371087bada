#include <specbake/core/ciede2000.h>

#include <cmath>
#include <numbers>

namespace specbake {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double power7(double v) {
    return std::pow(v, 7);
}

/// sqrt(C^7 / (C^7 + 25^7)), of (4) and (17).
double chromaWeight(double chroma) {
    return std::sqrt(power7(chroma) / (power7(chroma) + power7(25)));
}

/// (7): hue angle in [0, 360), 0 for a neutral.
double hueAngle(double a, double b) {
    if (a == 0 && b == 0) return 0;
    const double h = std::atan2(b, a) * kDegrees;
    return h < 0 ? h + 360 : h;
}

/// (10): the signed hue difference, 0 where one colour is neutral.
double hueDifference(double h1, double h2, bool neutral) {
    if (neutral) return 0;
    const double d = h2 - h1;
    if (d > 180) return d - 360;
    return d < -180 ? d + 360 : d;
}

/// (14): the mean hue on the shorter arc.
double meanHue(double h1, double h2, bool neutral) {
    if (neutral) return h1 + h2;
    if (std::abs(h1 - h2) <= 180) return (h1 + h2) / 2;
    return h1 + h2 < 360 ? (h1 + h2 + 360) / 2 : (h1 + h2 - 360) / 2;
}

double cosDegrees(double angle) {
    return std::cos(angle / kDegrees);
}

}  // namespace

double ciede2000(const Lab& first, const Lab& second) {
    const double meanChroma = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
    const double stretch = 1.5 - 0.5 * chromaWeight(meanChroma);  // 1 + G of (4), (5)
    const double a1 = stretch * first.a;
    const double a2 = stretch * second.a;
    const double C1 = std::hypot(a1, first.b);
    const double C2 = std::hypot(a2, second.b);
    const double h1 = hueAngle(a1, first.b);
    const double h2 = hueAngle(a2, second.b);
    const bool neutral = C1 * C2 == 0;

    const double dL = second.L - first.L;
    const double dC = C2 - C1;
    const double dH =
        2 * std::sqrt(C1 * C2) * std::sin(hueDifference(h1, h2, neutral) / 2 / kDegrees);

    const double L = (first.L + second.L) / 2;
    const double C = (C1 + C2) / 2;
    const double h = meanHue(h1, h2, neutral);
    const double T = 1 - 0.17 * cosDegrees(h - 30) + 0.24 * cosDegrees(2 * h) +
                     0.32 * cosDegrees(3 * h + 6) - 0.20 * cosDegrees(4 * h - 63);
    const double SL = 1 + 0.015 * (L - 50) * (L - 50) / std::sqrt(20 + (L - 50) * (L - 50));
    const double SC = 1 + 0.045 * C;
    const double SH = 1 + 0.015 * C * T;
    const double hueTurn = (h - 275) / 25;
    const double RT = -2 * chromaWeight(C) * std::sin(60 * std::exp(-hueTurn * hueTurn) / kDegrees);

    const double l = dL / SL;
    const double c = dC / SC;
    const double t = dH / SH;
    return std::sqrt(l * l + c * c + t * t + RT * c * t);
}

}  // namespace specbake
