#pragma once

#include "beside/image_beside.h"
#include "mip/box_filter.h"

#include <specbake/core/color_census.h>

#include <cstddef>
#include <vector>

namespace specbake::internal {

/// A run of rows on its way through the pipeline: whole rows of chunks of the file.
struct Band {
    int firstRow = 0;
    int rows = 0;
    int firstChunk = 0;
    int rowsAhead = 0;                           ///< of the next band, that `smaller` needs
    std::vector<std::byte> stored;               ///< as the texture holds them
    std::vector<std::vector<std::byte>> beside;  ///< the same rows of each image beside it
    std::vector<std::vector<std::byte>> packed;  ///< chunk by chunk, as the file will
    std::vector<TexelRow> smaller;               ///< rows of the level below, if there is one
    ColorCensus census;
    BesideCensus besideCensus;
};

}  // namespace specbake::internal
