#pragma once

#include "solvers.h"
#include "upsample/lookup.h"

#include <specbake/bake/bake.h>
#include <specbake/image/texture_reader.h>

#include <string>

namespace specbake {

/// A texture, the light under which its colours hold, and how they are solved.
struct Job {
    Job(const std::string& texture, const BakeOptions& options);
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    std::string path;
    TextureReader reader;
    ColorSpace space;
    Observer observer;
    MethodSolver solver;
    ColorResolver resolver;
    TexelDecoder decoder;
    LookupSpaces spaces;
    int threads;
    std::stop_token stop;
};

}  // namespace specbake
