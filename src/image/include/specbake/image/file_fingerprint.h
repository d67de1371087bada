#pragma once

#include <specbake/core/api.h>

#include <optional>
#include <string>

namespace specbake {

/// What tells a file's contents from others': its length and the CRC-32 of all of it (of zip and
/// PNG), as "1234 bytes, CRC-32 89abcdef". It tells changes from accidents, not from attackers.
/// Nothing for what is not a regular file, such as a pipe, which could be read only once.
/// Throws FileError if it cannot be read.
SPECBAKE_API std::optional<std::string> fileFingerprint(const std::string& path);

}  // namespace specbake
