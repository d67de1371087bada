#include "color/knot_place.h"

#include <specbake/core/spectrum.h>

#include <algorithm>
#include <cmath>

namespace specbake {

Spectrum constantSpectrum(double value) {
    Spectrum s;
    s.fill(value);
    return s;
}

internal::KnotPlace internal::placeOn(const Wavelengths& knots, double nm) {
    const double place = std::clamp((nm - knots.first) / knots.step, 0.0, double(knots.count - 1));
    const double below = std::min(std::floor(place), double(knots.count - 2));
    return {std::size_t(below), place - below};
}

double valueAt(const Spectrum& spectrum, const Wavelengths& knots, double nm) {
    const auto [below, ofNext] = internal::placeOn(knots, nm);
    return (1 - ofNext) * spectrum[below] + ofNext * spectrum[below + 1];
}

Spectrum mix(const Spectrum& a, const Spectrum& b, double weight) {
    Spectrum s;
    for (std::size_t m = 0; m < s.size(); ++m) s[m] = (1 - weight) * a[m] + weight * b[m];
    return s;
}

double maxDifference(const Spectrum& a, const Spectrum& b) {
    double largest = 0;
    for (std::size_t m = 0; m < a.size(); ++m) largest = std::max(largest, std::abs(a[m] - b[m]));
    return largest;
}

double rmsDifference(const Spectrum& a, const Spectrum& b) {
    double sum = 0;
    for (std::size_t m = 0; m < a.size(); ++m) sum += (a[m] - b[m]) * (a[m] - b[m]);
    return std::sqrt(sum / kBandCount);
}

double roughness(const Spectrum& s) {
    double sum = 0;
    for (std::size_t m = 1; m + 1 < s.size(); ++m) sum += std::abs(s[m - 1] - 2 * s[m] + s[m + 1]);
    return sum / (kBandCount - 2);
}

double boundsViolation(const Spectrum& s) {
    double worst = 0;
    for (const double value : s) worst = std::max({worst, -value, value - 1});
    return worst;
}

}  // namespace specbake
