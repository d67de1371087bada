#pragma once

#include <specbake/core/color.h>

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::bench {

/// The different colours of a texture, at most `count` of them, evenly thinned. The texture is of
/// sRGB or linear Rec.709, since the frame of the charts is sRGB's. Throws FileError.
std::vector<RGB> distinctColors(const std::string& texture, std::size_t count);

}  // namespace specbake::bench
