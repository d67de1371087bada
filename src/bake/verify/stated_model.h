#pragma once

#include "verify/sample_rounding.h"

#include <specbake/bake/verify.h>
#include <specbake/core/upsampler_options.h>
#include <specbake/image/spectral_reader.h>
#include <specbake/image/texture.h>

namespace specbake::internal {

/// What the texture's numbers mean: what the options say, else what the spectral file says that
/// they were taken for, else what the texture itself says. Throws ArgumentError, and FileError for
/// a texture without the ICC profile that the file was made by.
ColorMeaning statedMeaning(const SpectralReader& spectral, const TextureInfo& texture,
                           const VerifyOptions& options);

/// The light, the quadrature, the bands and the rule for colours outside by which the file was
/// made. No colour is solved. Throws FileError for a light, an observer, a quadrature or a rule of
/// the file that is not known, ArgumentError for a light of the options.
UpsamplerOptions statedModel(const std::string& path, const SpectralReader& spectral,
                             const VerifyOptions& options);

/// Of bands and preview: the type in which they are stored, and the bits that the file says it
/// kept.
SampleRounding statedRounding(const SpectralReader& spectral);

}  // namespace specbake::internal
