#include "verify/stated_model.h"

#include <specbake/bake/bake.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <charconv>

namespace specbake::internal {
namespace {

bool isIlluminant(const std::string& name) {
    const std::vector<std::string>& known = illuminantNames();
    return std::find(known.begin(), known.end(), name) != known.end();
}

}  // namespace

ColorSpace statedSpace(const SpectralReader& spectral, const TextureInfo& texture,
                       const VerifyOptions& options) {
    const auto name = options.space ? options.space : spectral.text("specbake:colorspace");
    if (!name || *name == "custom") return texture.automaticSpace;
    const ColorSpace* space = findColorSpace(*name);
    if (space == nullptr) throw ArgumentError("unknown colour space '" + *name + "'");
    return *space;
}

UpsamplerOptions statedModel(const std::string& path, const SpectralReader& spectral,
                             const VerifyOptions& options) {
    const auto refuseUnless = [&](bool known, const char* attribute, const std::string& value) {
        if (!known) {
            throw FileError(path,
                            std::string(attribute) + " is '" + value + "', which is not known");
        }
    };
    UpsamplerOptions model;
    const auto light = spectral.text("specbake:illuminant");
    if (light) refuseUnless(isIlluminant(*light), "specbake:illuminant", *light);
    model.illuminant = options.illuminant ? options.illuminant : light;
    if (const auto rule = spectral.text("specbake:outside")) {
        const auto known = outsideFromName(*rule);
        refuseUnless(known.has_value(), "specbake:outside", *rule);
        model.outside = *known;
    }
    if (const auto observer = spectral.text("specbake:observer")) {
        refuseUnless(*observer == Observer("E").name(), "specbake:observer", *observer);
    }
    return model;
}

SampleRounding statedRounding(const SpectralReader& spectral) {
    int bits = BakeOptions::kMostMantissaBits;
    if (const auto stated = spectral.text("specbake:bits")) {
        std::from_chars(stated->data(), stated->data() + stated->size(), bits);
    }
    return roundingOf(spectral.storedType(), bits);
}

}  // namespace specbake::internal
