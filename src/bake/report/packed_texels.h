#pragma once

#include "report/sampled_texels.h"

#include <string>

namespace specbake::internal {

/// Texels as text for a page: codes of 16 bits, linear from `low` to `high`, then what stands in
/// report/page/data.js, packed by zlib, in base64. What is not finite becomes `low`.
struct PackedTexels {
    double low = 0, high = 1;  ///< the least interval that holds [0, 1] and all bands
    std::string text;
};

PackedTexels packTexels(const SampledTexels& texels);

}  // namespace specbake::internal
