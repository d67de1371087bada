#pragma once

#include <string>
#include <vector>

namespace specbake::testing {

/// Files that no texture is, made in a folder when they are needed.
struct BadFile {
    std::string path;
    std::string says;  ///< what the refusal must hold, besides the path
};

/// Halves of the test images, and the same without their last tenth (where that holds pixels).
std::vector<BadFile> truncatedFiles(const std::string& folder);

/// Nothing, text, and garbage after each format's first bytes.
std::vector<BadFile> garbage(const std::string& folder);

/// Sound headers of images without end, and no pixels.
std::vector<BadFile> absurdSizes(const std::string& folder);

/// Sound images that are no textures: deep, not finite.
std::vector<BadFile> noTextures(const std::string& folder);

}  // namespace specbake::testing
