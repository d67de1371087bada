#pragma once

#include <specbake/core/adaptation.h>
#include <specbake/core/api.h>
#include <specbake/core/measured_sample.h>
#include <specbake/core/outside.h>
#include <specbake/core/quadrature.h>

#include <optional>
#include <string>
#include <vector>

namespace specbake {

/// Nodes along each axis of the lookup grid.
inline constexpr int kFewestGridNodes = 2;
inline constexpr int kMostGridNodes = 129;
inline constexpr int kDefaultGridNodes = 17;

/// How colours become spectra, whatever space they are in. The defaults are those of every program.
struct UpsamplerOptions {
    /// The light under which the colours hold, of illuminantNames(); none: the space's own white.
    std::optional<std::string> illuminant;
    /// Who sees the colours so: of observerNames(), or a table of one's own (quadrature.h).
    std::string observer{kUsualObserver};
    /// For a light that is not the space's own white (isAdapted()).
    Adaptation adapt = Adaptation::bradford;
    std::string method = "natural";  ///< of methods()
    /// Of materialNames(): near the colours of its samples, spectra are those of that material.
    std::optional<std::string> material;
    /// Measured samples, at most kMostSamples. At a sample's colour the spectrum is the sample
    /// (without a grid exactly), about it nearly so, far from all samples the method's. Samples of
    /// one colour are averaged.
    std::vector<MeasuredSample> samples;
    /// For which reader the colours are exact.
    Quadrature quadrature = Quadrature::bands;
    /// The bands of a spectrum; others than the usual 81 by the fine quadrature only.
    Wavelengths bands = {};
    Outside outside = Outside::nearest;
    /// Nodes of the lookup grid along each axis; none: each colour is solved by itself.
    std::optional<int> grid = kDefaultGridNodes;

    /// Whether an Upsampler can be made of this. `reason`, if it is given, says why not: one line.
    [[nodiscard]] SPECBAKE_API bool isValid(std::string* reason = nullptr) const;
};

}  // namespace specbake
