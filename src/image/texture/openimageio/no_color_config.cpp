#include "texture/openimageio/color_config.h"

#include <specbake/core/error.h>

namespace specbake::internal {

std::optional<ColorMeaning> meaningByConfig(const TextureInfo& /*texture*/,
                                            const ColorWishes& wishes) {
    throw FileError(*wishes.config, "this specbake was built without OpenColorIO");
}

}  // namespace specbake::internal
