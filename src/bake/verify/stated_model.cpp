#include "verify/stated_model.h"

#include "reading.h"

#include <specbake/bake/bake.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <charconv>

namespace specbake::internal {
namespace {

/// What the spectral file says, as a user would say it.
ColorWishes statedWishes(const SpectralReader& spectral, const std::string& space) {
    if (findColorSpace(space) != nullptr) return {space, {}, {}};
    return {{}, spectral.text("specbake:transfer"), spectral.text("specbake:primaries")};
}

/// By a configuration, which must be at hand and as it was.
ColorMeaning statedConfig(const std::string& space, const SpectralReader& spectral,
                          const TextureInfo& texture, const VerifyOptions& options) {
    if (!options.color.config) {
        throw FileError(texture.path,
                        "was taken for '" + space +
                            "' of a configuration of OpenColorIO, which --colorconfig "
                            "or $OCIO must name");
    }
    std::vector<std::string> unused;
    ColorWishes wishes = options.color;
    wishes.space = space;
    wishes.primaries = spectral.text("specbake:primaries");
    ColorMeaning meaning = chosenMeaning(texture, wishes, unused);
    if (meaning.configHash != spectral.text("specbake:confighash")) {
        throw FileError(*wishes.config, "'" + space +
                                            "' is not what it was when the spectral image was "
                                            "made: another configuration, or a changed one");
    }
    return meaning;
}

}  // namespace

ColorMeaning statedMeaning(const SpectralReader& spectral, const TextureInfo& texture,
                           const VerifyOptions& options) {
    std::vector<std::string> unused;
    const auto configSpace = spectral.text("specbake:configspace");
    if (configSpace && !options.color.any()) {
        return statedConfig(*configSpace, spectral, texture, options);
    }
    const ColorMeaning& own = texture.color;
    const auto space = spectral.text("specbake:colorspace");
    if (options.color.any() || !space) return chosenMeaning(texture, options.color, unused);
    const auto profile = spectral.text("specbake:iccprofile");
    if (profile && own.profile != *profile) {
        throw FileError(texture.path,
                        "has not the ICC profile by which its spectral image was made");
    }
    const auto source = spectral.text("specbake:colorsource");
    const bool same = source == colorSourceName(own.source) && own.space.name == *space;
    return chosenMeaning(texture, same ? ColorWishes() : statedWishes(spectral, *space), unused);
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
    // Files from before the attribute were not adapted.
    const std::string name = spectral.text("specbake:adaptation").value_or("none");
    const auto adaptation = adaptationFromName(name);
    refuseUnless(adaptation.has_value(), "specbake:adaptation", name);
    model.adapt = options.adapt.value_or(*adaptation);
    if (const auto rule = spectral.text("specbake:outside")) {
        const auto known = outsideFromName(*rule);
        refuseUnless(known.has_value(), "specbake:outside", *rule);
        model.outside = *known;
    }
    const Quadrature quadrature = statedQuadrature(path, spectral);
    model.observer = options.observer ? *options.observer : statedObserver(path, spectral);
    model.quadrature = options.quadrature.value_or(quadrature);
    if (model.quadrature == Quadrature::fine) model.bands = modelBands(spectral);
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
