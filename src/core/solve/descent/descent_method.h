#pragma once

#include <specbake/core/methods.h>

namespace specbake::internal {

/// The descent, and the shell (which never fails inside the solid) where it fails.
///
/// For the nodes of a grid it starts `flat`, which is continuous, and releases bounds, which does
/// not fail (docs/descent.md); for single colours it is the paper's own, with random starts and
/// bounds kept.
std::shared_ptr<const Solver> makeDescent(const Observer& observer, const Solid& solid,
                                          SolverUse use);

}  // namespace specbake::internal
