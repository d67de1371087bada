#pragma once

#include <specbake/core/observer.h>

namespace specbake::internal {

/// Brings the residual of a near solution down to rounding, where that costs nothing: the
/// least-norm correction of the components strictly within (0, 1), kept only if all of them stay
/// there and the residual shrinks. Returns max |W s - t| of the result.
double polish(const Observer& observer, const XYZ& color, Spectrum& spectrum);

}  // namespace specbake::internal
