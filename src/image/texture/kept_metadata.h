#pragma once

#include <string_view>

namespace specbake::internal {

/// Whether what a file says under this name still holds for a spectral image made from it: not if
/// it describes the old file's storage (compression, layout, colour profile) or is what the new
/// file says itself, and not under a name longer than OpenEXR's 255 characters.
bool isKeptMetadata(std::string_view name);

}  // namespace specbake::internal
