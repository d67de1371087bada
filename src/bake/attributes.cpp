#include "attributes.h"

#include <specbake/version.h>

namespace specbake::internal {

Attributes bakedAttributes(const Attributes& texture, const Upsampler& upsampler,
                           std::optional<int> bits) {
    const UpsamplerOptions& model = upsampler.options();
    Attributes all = texture;
    all["spectralLayoutVersion"] = "1.0";
    all["Software"] = std::string("specbake ") + kVersion;
    all["specbake:version"] = kVersion;
    all["specbake:method"] = model.method;
    if (model.material) all["specbake:material"] = *model.material;
    if (!model.samples.empty()) all["specbake:samples"] = upsampler.samplesIdentity();
    all["specbake:grid"] = model.grid.value_or(0);
    if (bits) all["specbake:bits"] = *bits;
    all["specbake:illuminant"] = upsampler.observer().illuminant();
    all["specbake:observer"] = std::string(upsampler.observer().name());
    all["specbake:colorspace"] = upsampler.space().name;
    all["specbake:outside"] = std::string(outsideName(model.outside));
    return all;
}

void addMaterials(Attributes& attributes, const std::vector<std::string>& materials,
                  const std::filesystem::path& map) {
    std::string names;
    for (const std::string& material : materials) names += (names.empty() ? "" : ",") + material;
    attributes["specbake:material"] = names;
    attributes["specbake:materialMap"] = map.filename().string();
}

}  // namespace specbake::internal
