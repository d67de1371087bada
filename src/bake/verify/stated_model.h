#pragma once

#include <specbake/bake/verify.h>
#include <specbake/core/color.h>
#include <specbake/core/upsampler_options.h>
#include <specbake/image/spectral_reader.h>
#include <specbake/image/texture.h>

namespace specbake::internal {

/// What the texture's numbers mean: what the options say, else what the spectral file says that
/// they were taken for, else what the texture itself says. Throws ArgumentError.
ColorSpace statedSpace(const SpectralReader& spectral, const TextureInfo& texture,
                       const VerifyOptions& options);

/// The light and the rule for colours outside by which the file was made. No colour is solved.
UpsamplerOptions statedModel(const SpectralReader& spectral, const VerifyOptions& options);

}  // namespace specbake::internal
