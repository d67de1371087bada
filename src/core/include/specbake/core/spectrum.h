#pragma once

#include <specbake/core/wavelengths.h>

#include <array>

namespace specbake {

/// One value a band: a reflectance in [0, 1] unless said otherwise.
using Spectrum = std::array<double, kBandCount>;

/// The same value in every band.
Spectrum constantSpectrum(double value);

/// (1 - weight) a + weight b. Stays within the bounds of a and b for weight in [0, 1].
Spectrum mix(const Spectrum& a, const Spectrum& b, double weight);

/// max |a_m - b_m|
double maxDifference(const Spectrum& a, const Spectrum& b);

/// sqrt(mean (a_m - b_m)^2)
double rmsDifference(const Spectrum& a, const Spectrum& b);

/// mean |s_{m-1} - 2 s_m + s_{m+1}|, the mean absolute second difference.
double roughness(const Spectrum& s);

/// How far the samples leave [0, 1]: 0 for a reflectance that conserves energy (2).
double boundsViolation(const Spectrum& s);

}  // namespace specbake
