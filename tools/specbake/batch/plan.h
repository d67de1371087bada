#pragma once

#include "batch/input_names.h"
#include "batch/output_names.h"

#include <optional>
#include <string>
#include <vector>

namespace specbake::tool {

/// One texture, and what it becomes.
struct BatchItem {
    Input input;
    std::string output;  ///< empty for a spectral image, which is passed over
    std::string page;    ///< the report on it; empty without one
};

/// The names of the results, and with `pages` of reports on them, all of them sound. Spectral
/// images that were found in a folder or by a pattern are passed over: it is into such folders that
/// results are written. Throws ArgumentError if two textures would become the same file, or if a
/// result is a texture of the batch or no `.exr`: nothing was begun then.
std::vector<BatchItem> planBatch(std::vector<Input> inputs, const OutputNames& names,
                                 const std::optional<OutputNames>& pages = {});

/// Throws ArgumentError, saying why, if a spectral image cannot have that name.
void checkSpectralName(const std::string& output);

}  // namespace specbake::tool
