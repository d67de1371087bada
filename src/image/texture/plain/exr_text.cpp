#include "texture/plain/exr_input.h"

#include <specbake/image/exr_text.h>

namespace specbake {

std::optional<std::string> exrText(const std::string& path, const std::string& attribute) {
    const internal::ExrInput input(path);
    std::int32_t length = 0;
    const char* text = nullptr;
    if (!input.isOpen() ||
        exr_attr_get_string(input.get(), 0, attribute.c_str(), &length, &text) != EXR_ERR_SUCCESS) {
        return {};
    }
    return std::string(text, std::size_t(length));
}

}  // namespace specbake
