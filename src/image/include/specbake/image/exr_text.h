#pragma once

#include <specbake/core/api.h>

#include <optional>
#include <string>

namespace specbake {

/// A string attribute of an EXR's first part, of whose file the header alone is read; nothing if
/// there is none, or if this is no EXR that could be read.
SPECBAKE_API std::optional<std::string> exrText(const std::string& path,
                                                const std::string& attribute);

}  // namespace specbake
