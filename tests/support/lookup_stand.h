#pragma once

#include "upsample/lookup.h"

#include <specbake/core/shell.h>

#include <optional>

namespace specbake::testing {

/// A lookup in a space under its own white, with everything that it stands on.
struct LookupStand {
    explicit LookupStand(const char* spaceName, std::optional<int> nodes = 17,
                         Outside rule = Outside::nearest)
        : space(*findColorSpace(spaceName)),
          observer(space.illuminant),
          solid(observer),
          solver(observer),
          resolver(solid, solver, rule),
          matrix(xyzFromRGB(space, observer.white())),
          lookup(nodes, {matrix, matrix}, resolver) {}

    /// What of the lookup's memory a mix needs stays in `scratch`.
    Mix mixOf(const SpectrumLookup::Color& color, SpectrumLookup::Scratch& scratch,
              TexelCensus& census) {
        Mix mix;
        lookup.locate({&color, 1}, 0, {&mix, 1}, scratch, census);
        return mix;
    }

    ColorSpace space;
    Observer observer;
    Solid solid;
    ShellSolver solver;
    ColorResolver resolver;
    Imath::M33d matrix;
    SpectrumLookup lookup;
};

}  // namespace specbake::testing
