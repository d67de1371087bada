#pragma once

#include <specbake/bake/baked_image.h>
#include <specbake/bake/model_cache.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace specbake::openimageio {

/// Which texture is seen as a spectral image, and how: the options of a bake.
struct Recipe {
    std::string source;
    std::string samples;  ///< a file of measured reflectances, "" for none
    std::string table;    ///< a file of spectra to look up, instead of a model; "" for none
    BakeOptions options;
    bool quadratureGiven = false;  ///< else it is fine where there are wavelengths
    std::string modelOption;       ///< the last one that was set of those of a model
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
/// is the name without its ending. A source and all other files are told from the text file's
/// folder; a source is no recipe itself. Unless it says otherwise the image is cut into tiles of 64
/// x 64 and has mip levels. Throws FileError, naming the line.
Recipe recipeOf(const std::string& path);

/// The image that it is of, with the samples and the table read. Throws FileError, and
/// ArgumentError for options that contradict each other.
std::unique_ptr<const BakedImage> imageOf(const Recipe& recipe, std::shared_ptr<ModelCache> models);

}  // namespace specbake::openimageio
