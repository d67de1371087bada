#pragma once

#include <specbake/core/color_space.h>

#include <optional>
#include <string>

namespace specbake::internal {

/// A remark for a file whose name says that it holds data and no colours, as texture libraries name
/// them: wood_nor_gl_1k.png, Bricks_Roughness.jpg, wall-height.exr. Nothing where the name also
/// says that it holds colours.
std::optional<std::string> remarkOnName(const std::string& path);

/// A remark for a file whose name says a space, as studios name them (wall_ACEScg.exr,
/// sky-lin_rec709.hdr), that nothing in the file does: it is taken for `taken`, another one.
std::optional<std::string> remarkOnSpace(const std::string& path, const ColorSpace& taken);

}  // namespace specbake::internal
