#pragma once

#include <specbake/core/color_census.h>
#include <specbake/image/texture.h>

namespace specbake::internal {

/// Throws FileError, naming the first, if texels of the texture have no spectrum. Numbers in the
/// census go through the data window row by row.
void refuseIncomplete(const TextureInfo& info, const ColorCensus& census);

}  // namespace specbake::internal
