#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>

namespace specbake {

/// The CIEDE2000 colour difference, kL = kC = kH = 1.
/// G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000 color-difference formula", Color Research &
/// Application 30(1), 2005; their numbering of the steps. Symmetric; 0 only for equal colours.
SPECBAKE_API double ciede2000(const Lab& first, const Lab& second);

}  // namespace specbake
