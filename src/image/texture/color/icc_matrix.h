#pragma once

#include "texture/color/icc_context.h"

#include <specbake/image/color_meaning.h>

namespace specbake::internal {

/// What a profile of three colorants and three curves means, as meaningOfProfile() says.
ColorMeaning meaningOfMatrix(const IccProfile& profile);

}  // namespace specbake::internal
