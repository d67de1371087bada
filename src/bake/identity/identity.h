#pragma once

#include <specbake/bake/bake.h>
#include <specbake/core/upsampler.h>

#include <string>

namespace specbake::internal {

/// The attribute by which a spectral file tells what it was made of, and how.
inline constexpr const char* kIdentityAttribute = "specbake:identity";
inline constexpr const char* kIdentitySeparator = "; ";

/// All that the bytes of a bake depend on, as one line of text: `source` (fileFingerprint() of the
/// texture), the options as they were asked for, and the version. `model` is the one that
/// `options.model` describes, `meaning` what the
/// texture's numbers were taken for.
std::string bakeIdentity(const std::string& source, const Upsampler& model,
                         const ColorMeaning& meaning, const BakeOptions& options);

}  // namespace specbake::internal
