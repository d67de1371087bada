#pragma once

#include <specbake/bake/bake.h>
#include <specbake/image/texture.h>

namespace specbake::internal {

/// The colour space that a texture is taken for. Throws ArgumentError for an unknown name.
ColorSpace chosenSpace(const TextureInfo& info, const BakeOptions& options);

}  // namespace specbake::internal
