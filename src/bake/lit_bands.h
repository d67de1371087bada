#pragma once

#include <specbake/bake/relight.h>
#include <specbake/image/spectral_reader.h>

#include <Imath/ImathVec.h>

#include <string>
#include <vector>

namespace specbake::internal {

/// What each band gives to linear Rec.709 R, G, B at reflectance 1.
using LitBands = std::vector<Imath::V3f>;

/// The weights of the file's bands (reading.h) under the light of the options, adapted to it if
/// asked for, scaled as relight.h says. Throws ArgumentError for an unknown light, FileError where
/// the file has not the bands of the quadrature.
LitBands litBands(const std::string& path, const SpectralReader& reader,
                  const RelightOptions& options);

}  // namespace specbake::internal
