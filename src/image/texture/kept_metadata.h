#pragma once

#include <specbake/image/image_types.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// Whether what a file says under this name still holds for a spectral image made from it: not if
/// it describes the old file's storage (compression, layout, colour profile) or is what the new
/// file says itself.
bool isKeptMetadata(std::string_view name);

/// Whether an attribute can be a vector of so many floats.
constexpr bool isVectorSize(std::size_t floats) {
    return floats == 2 || floats == 3 || floats == 9 || floats == 16;
}

/// Removes what an EXR cannot hold under its name, with a note that names it: names of no or of
/// more than 31 characters (longer ones need a flag with which older readers refuse the file), and
/// those of the attributes by which EXR describes its own parts.
void keepWhatFits(Attributes& attributes, std::vector<std::string>& notes);

}  // namespace specbake::internal
