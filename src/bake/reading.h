#pragma once

#include <specbake/core/color.h>
#include <specbake/core/quadrature.h>
#include <specbake/image/spectral_reader.h>

#include <Imath/ImathVec.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// How many rows of a spectral image are best looked at together: those of a ZIP chunk, or fewer
/// where they are long.
int rowsTogether(const SpectralReader& spectral);

/// How many threads to look at them with: one where rows are so long that each more under way would
/// take tens of megabytes. Reading, which goes in order, takes the most time.
int threadsFor(const SpectralReader& spectral, int threads);

/// The quadrature for which a file says that its colours are exact. Of a file that says nothing:
/// the sum over the bands if it has the usual 81, else the fine one. Throws FileError for another.
Quadrature statedQuadrature(const std::string& path, const SpectralReader& spectral);

/// A file's bands as those of a model: where they are evenly spaced and a model can have them, else
/// the usual 81.
Wavelengths modelBands(const SpectralReader& spectral);

/// The observer for whom a file says that its colours hold (quadrature.h); of a file that says
/// nothing, the usual one. Throws FileError for one that is not known.
std::string statedObserver(const std::string& path, const SpectralReader& spectral);

/// What each band of a file gives to a reader of that quadrature, under a light, to an observer
/// (quadrature.h). Throws FileError where the sum over the bands is asked of others than the usual
/// 81, ArgumentError for an unknown light or observer.
std::vector<Imath::V3d> readerWeights(const std::string& path, const SpectralReader& spectral,
                                      std::string_view illuminant, Quadrature quadrature,
                                      std::string_view observer = kUsualObserver);

/// The perfect reflector, as that reader sees it: the sum of the weights.
XYZ whiteOf(const std::vector<Imath::V3d>& weights);

}  // namespace specbake::internal
