#pragma once

#include <specbake/core/api.h>
#include <specbake/core/upsampler.h>

#include <cstddef>
#include <vector>

namespace specbake {

/// How far a table's colours are from those asked for: CIEDE2000 under its light.
struct TableErrors {
    double mean = 0, p99 = 0, max = 0;
    std::size_t colors = 0;  ///< how many were drawn
    double share = 0;        ///< of the cube, by the grid's own measure, that they stand for
};

/// A model as a file that renderers look spectra up in: `specbake/sampler.h` reads it,
/// docs/table-format.md describes it.
struct SpectralTableFile {
    std::vector<std::byte> bytes;
    TableErrors everywhere;  ///< over the colours of the cube that a reflectance can have
    TableErrors atBoundary;  ///< over those of them whose cell the solid's boundary cuts
    /// The errors for a reader of the other quadrature, over the same colours.
    TableErrors everywhereOtherwise, atBoundaryOtherwise;
    Quadrature quadrature = Quadrature::bands;  ///< of the first two
};

/// The upsampler's grid as a table of 16-bit samples. Nodes that the solid does not hold get values
/// beyond [0, 1], such that the colours between them and the solid keep their colour
/// (docs/table-format.md). The same bytes at every call.
/// Throws ArgumentError for a model without a grid, and for XYZ, whose cube is not its own.
[[nodiscard]] SPECBAKE_API SpectralTableFile spectralTable(const Upsampler& upsampler);

}  // namespace specbake
