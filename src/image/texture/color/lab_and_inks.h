#pragma once

#include "texture/color/color_signs.h"

#include <specbake/image/color_meaning.h>
#include <specbake/image/image_types.h>

#include <string>
#include <vector>

namespace specbake::internal {

bool isLab(ColorModel model);
bool isInks(ColorModel model);

/// What the channels of inks or of Lab are called; none for others, whose files say it.
const std::vector<std::string>& colorNames(ColorModel model);

/// Lab beside D50, as `model` stores it, to linear colours of lin_prophoto. `type`: uint8 or
/// uint16.
std::shared_ptr<const PixelTransform> transformOfLab(ColorModel model, TexelType type);

/// Inks without a profile, as the product of what each leaves of the light, through that curve:
/// what programs show that know no better.
std::shared_ptr<const PixelTransform> transformOfInks(ColorModel model, const Transfer& transfer);

}  // namespace specbake::internal
