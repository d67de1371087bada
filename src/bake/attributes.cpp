#include "attributes.h"

#include <specbake/version.h>

#include <fmt/format.h>

namespace specbake::internal {
namespace {

void put(Attributes& all, const char* name, std::string text) {
    all.insert_or_assign(name, std::move(text));
}

/// What is needed to know the numbers' meaning again, and no more: a name, where it says all.
void addMeaning(const ColorMeaning& meaning, Attributes& all) {
    const ColorSpace& space = meaning.space;
    put(all, "specbake:colorspace", space.name);
    put(all, "specbake:colorsource", std::string(colorSourceName(meaning.source)));
    if (!meaning.profile.empty()) put(all, "specbake:iccprofile", meaning.profile);
    if (findColorSpace(space.name) != nullptr) return;
    put(all, "specbake:primaries", primariesText(*space.primaries));
    if (!meaning.curves) put(all, "specbake:transfer", transferName(space.transfer));
}

}  // namespace

Attributes bakedAttributes(const Attributes& texture, const ColorMeaning& meaning,
                           const Upsampler& upsampler, std::optional<int> bits) {
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
    addMeaning(meaning, all);
    if (isAdapted(meaning.space, upsampler.observer())) {
        put(all, "specbake:adaptation", std::string(adaptationName(model.adapt)));
    }
    if (model.quadrature != Quadrature::bands) {
        put(all, "specbake:quadrature", std::string(quadratureText(model.quadrature)));
    }
    if (model.bands != Wavelengths()) {
        put(all, "specbake:wavelengths", wavelengthsText(model.bands));
    }
    all["specbake:outside"] = std::string(outsideName(model.outside));
    return all;
}

void addMaterials(Attributes& attributes, const std::vector<std::string>& materials,
                  const std::filesystem::path& map) {
    attributes["specbake:material"] = fmt::format("{}", fmt::join(materials, ","));
    attributes["specbake:materialMap"] = map.filename().string();
}

void addSecond(Attributes& attributes, const std::string& light,
               const std::filesystem::path& image) {
    attributes["specbake:secondIlluminant"] = light;
    attributes["specbake:secondImage"] = image.filename().string();
}

void addChosen(Attributes& attributes, const BakeOptions& options) {
    if (options.storage.isTiled()) {
        put(attributes, "textureformat", "Plain Texture");
        put(attributes, "wrapmodes", "black,black");
    }
    for (const auto& [name, value] : options.attributes) attributes.insert_or_assign(name, value);
}

}  // namespace specbake::internal
