#include "model_options.h"

#include <specbake/core/error.h>

namespace specbake::python {

const ColorSpace& spaceNamed(const std::string& name) {
    const ColorSpace* space = findColorSpace(name);
    if (space == nullptr) throw ArgumentError("unknown colour space '" + name + "'");
    return *space;
}

UpsamplerOptions modelOptions(const std::optional<std::string>& light, const std::string& method,
                              const std::string& outside, std::optional<int> grid) {
    UpsamplerOptions options;
    options.illuminant = light;
    options.method = method;
    const std::optional<Outside> rule = outsideFromName(outside);
    if (!rule) throw ArgumentError("unknown rule for colours outside: '" + outside + "'");
    options.outside = *rule;
    options.grid = grid;
    return options;
}

}  // namespace specbake::python
