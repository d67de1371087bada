#include "attributes.h"

#include "identity/identity.h"
#include "identity/sha1.h"

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
    if (meaning.source == ColorSource::config) {
        put(all, "specbake:configspace", meaning.configSpace);
        put(all, "specbake:confighash", meaning.configHash);
    }
    if (findColorSpace(space.name) != nullptr) return;
    put(all, "specbake:primaries", primariesText(*space.primaries));
    if (!meaning.curves) put(all, "specbake:transfer", transferName(space.transfer));
}

/// Whoever made the spectra.
Attributes begun(const Attributes& texture) {
    Attributes all = texture;
    all["spectralLayoutVersion"] = "1.0";
    all["Software"] = std::string("specbake ") + kVersion;
    all["specbake:version"] = kVersion;
    return all;
}

void addObserver(const ColorMeaning& meaning, const Observer& observer, Adaptation adapt,
                 Attributes& all) {
    put(all, "specbake:illuminant", observer.illuminant());
    put(all, "specbake:observer", std::string(observer.name()));
    addMeaning(meaning, all);
    if (isAdapted(meaning.space, observer)) {
        put(all, "specbake:adaptation", std::string(adaptationName(adapt)));
    }
    if (observer.quadrature() != Quadrature::bands) {
        put(all, "specbake:quadrature", std::string(quadratureText(observer.quadrature())));
    }
    if (observer.bands() != Wavelengths()) {
        put(all, "specbake:wavelengths", wavelengthsText(observer.bands()));
    }
}

}  // namespace

Attributes bakedAttributes(const Attributes& texture, const ColorMeaning& meaning,
                           const Upsampler& upsampler, std::optional<int> bits) {
    const UpsamplerOptions& model = upsampler.options();
    Attributes all = begun(texture);
    all["specbake:method"] = model.method;
    if (model.material) all["specbake:material"] = *model.material;
    if (!model.samples.empty()) all["specbake:samples"] = upsampler.samplesIdentity();
    all["specbake:grid"] = model.grid.value_or(0);
    if (bits) all["specbake:bits"] = *bits;
    addObserver(meaning, upsampler.observer(), model.adapt, all);
    all["specbake:outside"] = std::string(outsideName(model.outside));
    return all;
}

Attributes tabulatedAttributes(const Attributes& texture, const ColorMeaning& meaning,
                               const TableFile& table, const Observer& observer, Adaptation adapt,
                               std::optional<int> bits) {
    Attributes all = begun(texture);
    put(all, "specbake:table", std::filesystem::path(table.name()).filename().string());
    put(all, "specbake:method", table.fact("method").value_or(""));
    all["specbake:grid"] = int(table.view().header().nodes);
    if (bits) all["specbake:bits"] = *bits;
    addObserver(meaning, observer, adapt, all);
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

void addIdentity(Attributes& attributes, const std::string& identity, const BakeOptions& options) {
    attributes[kIdentityAttribute] = identity;
    if (options.storage.isTiled()) attributes["oiio:SHA-1"] = sha1(identity);
}

void addChosen(Attributes& attributes, const BakeOptions& options) {
    if (options.storage.isTiled()) {
        put(attributes, "textureformat", "Plain Texture");
        put(attributes, "wrapmodes", "black,black");
    }
    for (const auto& [name, value] : options.attributes) attributes.insert_or_assign(name, value);
}

}  // namespace specbake::internal
