#pragma once

#include <specbake/core/api.h>
#include <specbake/core/solid.h>
#include <specbake/core/solver.h>

#include <memory>
#include <span>
#include <string_view>

namespace specbake {

/// What a solver is made for.
enum class SolverUse {
    gridNodes,    ///< spectra are blended between nodes: near colours must have near spectra
    singleColors  ///< each colour by itself
};

/// A way from a colour to a spectrum, by its name.
struct Method {
    std::string_view name;
    std::string_view summary;  ///< a few words, for a list of choices

    /// A solver that answers for every colour of the solid: where the method itself fails, the
    /// report says `fellBack`, or `blended`. `solid` is the observer's.
    std::shared_ptr<const Solver> (*makeSolver)(const Observer& observer, const Solid& solid,
                                                SolverUse use);
};

/// Every method that is offered. The first is the default.
SPECBAKE_API std::span<const Method> methods();

/// The method of that name, or nullptr.
SPECBAKE_API const Method* findMethod(std::string_view name);

}  // namespace specbake
