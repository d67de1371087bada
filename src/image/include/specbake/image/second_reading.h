#pragma once

#include <specbake/core/api.h>

#include <optional>
#include <string>

namespace specbake {

/// A texture's file, read by both of the readers that know it.
struct SecondReading {
    bool possible = false;  ///< false: one reader alone reads this file as it is stored
    /// What the two do not read alike, as one line: nothing if they agree.
    std::optional<std::string> difference;
};

/// PNG, JPEG and EXR files that hold nothing unusual are read by readers of our own, as
/// TextureReader does; OpenImageIO reads them too, but for the inks of a JPEG, which it mixes.
/// Compares windows, channels, alpha, types, what is said of colours, and every stored sample of
/// the two. Throws FileError if either cannot read the file.
SPECBAKE_API SecondReading compareReadings(const std::string& path);

}  // namespace specbake
