#pragma once

#include <specbake/bake/bake.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace specbake::openimageio {

/// Which texture is seen as a spectral image, and how: the options of a bake.
struct Recipe {
    std::string source;
    BakeOptions options;
};

/// Text beyond this is no recipe.
inline constexpr std::size_t kLongestRecipe = 1 << 16;  // bytes

/// Sets one option by the name that `specbake bake` has for it, without the dashes; `source` too.
/// Throws ArgumentError, with the reason.
void setOption(Recipe& recipe, std::string_view name, std::string_view value);

/// Hands over every name that setOption() knows.
void forEachOption(const std::function<void(std::string_view)>& take);

/// The recipe of a name that ends in .spectral. A text file of that name has lines `name = value`,
/// empty ones, and such as begin with #. Without a source in it, or without such a file, the source
/// is the name without its ending. A source is told from the text file's folder, and is no recipe
/// itself. Unless it says otherwise the image is cut into tiles of 64 x 64 and has mip levels.
/// Throws FileError, naming the line.
Recipe recipeOf(const std::string& path);

}  // namespace specbake::openimageio
