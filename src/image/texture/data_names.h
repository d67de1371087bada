#pragma once

#include <optional>
#include <string>

namespace specbake::internal {

/// A remark for a file whose name says that it holds data and no colours, as texture libraries name
/// them: wood_nor_gl_1k.png, Bricks_Roughness.jpg, wall-height.exr. Nothing where the name also
/// says that it holds colours.
std::optional<std::string> remarkOnName(const std::string& path);

}  // namespace specbake::internal
