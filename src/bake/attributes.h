#pragma once

#include <specbake/bake/bake.h>
#include <specbake/core/upsampler.h>
#include <specbake/image/color_meaning.h>
#include <specbake/image/image_types.h>
#include <specbake/image/table_file.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace specbake::internal {

/// The texture's metadata with what is needed to know how the file was made (docs/file-format.md).
/// `bits`: of the mantissa of half samples; none for floats.
Attributes bakedAttributes(const Attributes& texture, const ColorMeaning& meaning,
                           const Upsampler& upsampler, std::optional<int> bits);

/// The same of spectra that are looked up in a table.
Attributes tabulatedAttributes(const Attributes& texture, const ColorMeaning& meaning,
                               const TableFile& table, const Observer& observer, Adaptation adapt,
                               std::optional<int> bits);

/// The materials of a map, and its file's name.
void addMaterials(Attributes& attributes, const std::vector<std::string>& materials,
                  const std::filesystem::path& map);

/// The second light, and the file with the colours under it.
void addSecond(Attributes& attributes, const std::string& light,
               const std::filesystem::path& image);

/// What the options say of the file beside its model: where it is stored as renderers fetch it, the
/// marks of maketx (its kind of texture; black beyond its edges), and the attributes of one's own.
void addChosen(Attributes& attributes, const BakeOptions& options);

/// What the file was made of and how; of tiled files also the fingerprint by which OpenImageIO
/// knows files of the same pixels, `oiio:SHA-1`: of this text, as pixels are the same where it is.
void addIdentity(Attributes& attributes, const std::string& identity, const BakeOptions& options);

}  // namespace specbake::internal
