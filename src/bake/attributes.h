#pragma once

#include <specbake/bake/bake.h>

namespace specbake {

/// The texture's metadata with what is needed to know how the file was made (docs/file-format.md).
Attributes bakedAttributes(const Attributes& texture, const BakeOptions& options,
                           const ColorSpace& space, const std::string& illuminant);

}  // namespace specbake
