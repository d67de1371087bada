#include "beside/image_beside.h"

#include <specbake/core/error.h>

#include <string>

namespace specbake::internal {

ImageBeside::ImageBeside(Texture& image, const TextureInfo& texture, const char* what)
    : image_(image) {
    const auto size = [](const Window& w) {
        return std::to_string(w.width) + " x " + std::to_string(w.height);
    };
    const Window &own = image.info().data, &its = texture.data;
    if (own.width == its.width && own.height == its.height) return;
    throw FileError(image.info().path, std::string(what) + " has the size of its texture, " +
                                           size(its) + ", not " + size(own));
}

}  // namespace specbake::internal
