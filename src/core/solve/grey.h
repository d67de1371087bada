#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

#include <optional>

namespace specbake::internal {

/// The flat spectrum of a colour that is grey to the rounding of a 3x3 product; black and white get
/// 0 and 1 exactly. Status `outside` for greys beyond black and white. Nothing for other colours.
std::optional<Solution> greySolution(const Observer& observer, const XYZ& color);

}  // namespace specbake::internal
