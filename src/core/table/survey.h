#pragma once

#include "table/node_spectra.h"

#include <specbake/core/table.h>
#include <specbake/sampler.h>

namespace specbake::internal {

/// The errors of a finished table, from 20,000 colours each.
struct TableSurvey {
    TableErrors everywhere;
    TableErrors atBoundary;
};
TableSurvey surveyed(const SpectralTable& table, const Grid& grid, const NodeSpectra& nodes,
                     const Upsampler& upsampler);

}  // namespace specbake::internal
