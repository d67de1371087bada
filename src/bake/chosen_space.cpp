#include "chosen_space.h"

#include <specbake/core/error.h>

namespace specbake::internal {

ColorSpace chosenSpace(const TextureInfo& info, const BakeOptions& options) {
    if (!options.space) return info.automaticSpace;
    const ColorSpace* space = findColorSpace(*options.space);
    if (space == nullptr) throw ArgumentError("unknown colour space '" + *options.space + "'");
    return *space;
}

}  // namespace specbake::internal
