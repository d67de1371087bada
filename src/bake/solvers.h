#pragma once

#include <specbake/bake/bake.h>
#include <specbake/core/solid.h>
#include <specbake/core/solver.h>

#include <memory>
#include <string_view>

namespace specbake {

std::string_view methodName(Method method);

/// The solver of a bake, which never fails inside the solid. The observer and the solid must
/// outlive it.
std::unique_ptr<Solver> makeSolver(const BakeOptions& options, const Observer& observer,
                                   const Solid& solid);

}  // namespace specbake
