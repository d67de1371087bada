#pragma once

#include "colors/sets.h"
#include "methods/csv.h"
#include "methods/method.h"

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace specbake::bench {

/// A method failed on a colour where it says so itself, where the colour is visibly missed, or
/// where a sample leaves [0, 1] by more than a thousandth.
inline constexpr double kVisible = 1;  // CIEDE2000
inline constexpr double kUsableViolation = 1e-3;

struct Verdict {
    double residual = 0;   ///< max |ΔXYZ|
    double deltaE = 0;     ///< CIEDE2000 under the frame's illuminant
    double violation = 0;  ///< how far samples leave [0, 1]
    bool failed = false;
};
Verdict judge(const Method& method, const XYZ& color, const Reconstruction& result);

/// A named number with its unit, before it is known what it was measured on.
struct Measure {
    std::string quantity;
    double value = 0;
    std::string unit;
};

/// Round trip, bounds (shares of colours and of their samples), failures and roughness over a set,
/// of spectra rounded to float as textures hold them.
std::vector<Measure> measureRoundTrip(const Method& method, const ColorSet& set);

/// max_m |Δs_m| / max |ΔRGB| of each colour and a neighbour that differs by `distance` in each of
/// R, G, B, in a seeded direction; inside the unit cube where the colour is.
std::vector<double> continuity(const Method& method, const std::vector<XYZ>& colors,
                               double distance);
/// Median, 99.9 % and largest of these over a set.
std::vector<Measure> measureContinuity(const Method& method, const ColorSet& set);

/// A light as a set of weights: an observer, or one of a table that specbake does not offer.
struct Light {
    std::string name;
    std::array<Imath::V3d, kBandCount> weights;
    XYZ white;

    XYZ color(const Spectrum& s) const;
};
Light lightOf(const Observer& observer);
/// data/illuminant_*.csv: wavelength, power. Throws FileError.
Light readLight(const std::string& name, const std::string& path);

/// Measured reflectances rebuilt from their colour under the method's illuminant: how near is the
/// result, and what does it look like under other lights?
std::vector<Measure> measureNature(const Method& method, const std::vector<NamedSpectrum>& measured,
                                   const std::vector<Light>& lights);

/// Texels a second of each method on one thread, 81 floats a texel, texels uniform in the RGB cube:
/// the median of `runs` runs of about `runTime` each. The methods take turns, so that what else the
/// machine does meets all of them alike.
std::vector<double> throughput(const std::vector<const Method*>& methods, int runs,
                               std::chrono::duration<double> runTime);

/// Seconds of processor time that `work` takes: what other programs use does not count.
double secondsOf(const std::function<void()>& work);

}  // namespace specbake::bench
