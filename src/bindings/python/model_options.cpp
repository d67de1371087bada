#include "model_options.h"

#include <specbake/core/error.h>
#include <specbake/image/measured_file.h>

namespace specbake::python {

UpsamplerOptions modelOptions(const std::optional<std::string>& light,
                              const std::optional<std::string>& method, const std::string& outside,
                              std::optional<int> grid, const std::optional<std::string>& material,
                              const std::optional<std::filesystem::path>& samples) {
    UpsamplerOptions options;
    options.illuminant = light;
    if (method) options.method = *method;
    const std::optional<Outside> rule = outsideFromName(outside);
    if (!rule) throw ArgumentError("unknown rule for colours outside: '" + outside + "'");
    options.outside = *rule;
    options.grid = grid;
    options.material = material;
    if (samples) options.samples = readMeasuredFile(samples->string()).samples;
    return options;
}

}  // namespace specbake::python
