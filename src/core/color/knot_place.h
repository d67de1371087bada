#pragma once

#include <specbake/core/wavelengths.h>

#include <cstddef>

namespace specbake::internal {

/// Between which knots a wavelength lies: (1 - ofNext) of knot `below`, ofNext of the next.
struct KnotPlace {
    std::size_t below = 0;
    double ofNext = 0;  ///< in [0, 1]
};

/// Of a finite `nm`; before the first knot and beyond the last, these. `knots`: two at least.
KnotPlace placeOn(const Wavelengths& knots, double nm);

}  // namespace specbake::internal
