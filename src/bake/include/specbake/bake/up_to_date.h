#pragma once

#include <specbake/bake/bake.h>

#include <filesystem>
#include <optional>
#include <string>

namespace specbake {

/// How a texture is compared with the one that a result was made of.
enum class SourceCheck {
    bytes,  ///< all its bytes are read
    length  ///< by its length, and its time: of neither file more than the header is read
};

/// Why `output` has to be made (again) by bake(input, output, options), as one line; nothing if it
/// is current.
///
/// It is current if it is no older than its texture, and if its attribute `specbake:identity` says
/// that it was made of the same bytes, by the same options and by the same version. Throws what
/// bake() throws for a texture that cannot be read.
[[nodiscard]] SPECBAKE_API std::optional<std::string> outdated(
    const std::string& input, const std::filesystem::path& output, const BakeOptions& options,
    SourceCheck check = SourceCheck::bytes);

}  // namespace specbake
