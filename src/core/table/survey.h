#pragma once

#include "table/node_spectra.h"

#include <specbake/core/table.h>
#include <specbake/sampler.h>

namespace specbake::internal {

/// The errors of a finished table, from 20,000 colours each, for a reader of one quadrature.
struct ReaderErrors {
    TableErrors everywhere;
    TableErrors atBoundary;
};

struct TableSurvey {
    ReaderErrors own;        ///< of the quadrature that the table was made for
    ReaderErrors otherwise;  ///< of the other one
};
TableSurvey surveyed(const SpectralTable& table, const Grid& grid, const NodeSpectra& nodes,
                     const Upsampler& upsampler);

}  // namespace specbake::internal
