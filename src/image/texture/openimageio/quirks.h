#pragma once

#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

namespace specbake::internal {

/// Makes true what a reader of OpenImageIO says wrongly of its format: whether there is alpha, and
/// whether colour is multiplied by it ("oiio:UnassociatedAlpha"). quirks.cpp has them all. Returns
/// a line on what the reader has lost, for a user to know.
std::vector<std::string> correctQuirks(const std::string& format, OIIO::ImageSpec& spec);

/// Throws FileError for a description that contradicts itself, or of sizes beyond all bounds, so
/// that no index or size taken from it lies past a buffer. An alpha channel that is not there is
/// forgotten.
void checkConsistency(const std::string& path, OIIO::ImageSpec& spec);

}  // namespace specbake::internal
