#include "verify/stated_model.h"

#include <specbake/core/error.h>

namespace specbake::internal {

ColorSpace statedSpace(const SpectralReader& spectral, const TextureInfo& texture,
                       const VerifyOptions& options) {
    const auto name = options.space ? options.space : spectral.text("specbake:colorspace");
    if (!name || *name == "custom") return texture.automaticSpace;
    const ColorSpace* space = findColorSpace(*name);
    if (space == nullptr) throw ArgumentError("unknown colour space '" + *name + "'");
    return *space;
}

UpsamplerOptions statedModel(const SpectralReader& spectral, const VerifyOptions& options) {
    UpsamplerOptions model;
    model.illuminant =
        options.illuminant ? options.illuminant : spectral.text("specbake:illuminant");
    const auto rule = spectral.text("specbake:outside");
    if (rule) model.outside = outsideFromName(*rule).value_or(model.outside);
    return model;
}

}  // namespace specbake::internal
