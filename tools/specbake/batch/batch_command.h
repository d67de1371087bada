#pragma once

#include "batch/input_names.h"
#include "batch/report.h"
#include "commands.h"

#include <specbake/bake/bake.h>

namespace specbake::tool {

/// What `bake` does with several textures.
struct BatchArguments {
    Inputs inputs;
    std::string output;
    std::string pages;    ///< reports, named as the results are; empty for none
    BakeOptions options;  ///< of each
    bool update = false;
    std::string shard;  ///< as parseShard() takes it; empty for all
    BatchReport::Options report;
};

/// kFailed if any texture was not baked. Throws ArgumentError before anything is begun.
ExitCode batchCommand(const BatchArguments& arguments);

}  // namespace specbake::tool
