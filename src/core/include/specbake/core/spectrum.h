#pragma once

#include <specbake/core/api.h>
#include <specbake/core/wavelengths.h>

#include <array>

namespace specbake {

/// One value a band: a reflectance in [0, 1] unless said otherwise.
using Spectrum = std::array<double, kBandCount>;

/// The same value in every band.
SPECBAKE_API Spectrum constantSpectrum(double value);

/// The spectrum whose first knots.count values stand at the knots, at `nm`: linear between them,
/// the ends repeated.
SPECBAKE_API double valueAt(const Spectrum& spectrum, const Wavelengths& knots, double nm);

/// (1 - weight) a + weight b. Stays within the bounds of a and b for weight in [0, 1].
SPECBAKE_API Spectrum mix(const Spectrum& a, const Spectrum& b, double weight);

/// max |a_m - b_m|
SPECBAKE_API double maxDifference(const Spectrum& a, const Spectrum& b);

/// sqrt(mean (a_m - b_m)^2)
SPECBAKE_API double rmsDifference(const Spectrum& a, const Spectrum& b);

/// mean |s_{m-1} - 2 s_m + s_{m+1}|, the mean absolute second difference.
SPECBAKE_API double roughness(const Spectrum& s);

/// How far the samples leave [0, 1]: 0 for a reflectance that conserves energy (2).
SPECBAKE_API double boundsViolation(const Spectrum& s);

}  // namespace specbake
