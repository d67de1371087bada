#pragma once

#include <specbake/image/texture.h>

#include <optional>

namespace specbake::internal {

/// What a texture's numbers mean by the configuration of OpenColorIO that the wishes name: of their
/// space, or without one of what the file rules say of the texture's path. Nothing where no rule
/// but the default one knows the path, or the space is not the configuration's but one of
/// colorSpaces(). Colours go to acescg if the configuration has it, else to the next that it has of
/// lin_rec709, lin_rec2020 and aces2065-1, else by its role aces_interchange, or to its role
/// scene_linear with the wishes' primaries.
/// Throws FileError for a configuration that cannot be read, and ArgumentError for a space that is
/// not known or holds no colours, or where none of these ways is there.
std::optional<ColorMeaning> meaningByConfig(const TextureInfo& texture, const ColorWishes& wishes);

}  // namespace specbake::internal
