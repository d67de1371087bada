#pragma once

#include "color/tables.h"

#include <specbake/core/quadrature.h>

#include <Imath/ImathVec.h>

#include <memory>
#include <string>
#include <string_view>

namespace specbake::internal {

/// The colour-matching functions of an observer.
struct ColorMatching {
    std::string name;              ///< in full, or the text of a table of one's own
    tables::BandMatching bands{};  ///< what is decided exactly is decided on these
    tables::FineMatching fine{};

    /// x̄, ȳ, z̄ of a band. The quotient is the double nearest to the printed decimal: both the
    /// integer and 1e10 are exact.
    Imath::V3d at(std::size_t band) const {
        const auto& c = bands[band];
        return Imath::V3d(double(c[0]), double(c[1]), double(c[2])) / tables::kMatchingUnitsPerOne;
    }
};

/// An offered observer, or a table of one's own in the form of observerText(). Throws ArgumentError
/// where there is none.
std::shared_ptr<const ColorMatching> matchingNamed(std::string_view text);

}  // namespace specbake::internal
