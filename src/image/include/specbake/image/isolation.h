#pragma once

#include <specbake/core/api.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace specbake {

/// Which files are read in a process of their own, where a reader that crashes, or takes memory
/// without end, is an error of its file.
enum class Isolation {
    automatic,  ///< all but PNG, JPEG, EXR and TIFF, whose readers have stood up to hostile files
    always,
    never
};

/// "auto", "always", "never".
SPECBAKE_API std::optional<Isolation> isolationFromName(std::string_view name);

/// From then on files are read so. `program`, with the words behind it, must call
/// serveIsolatedReads(0). Without this call nothing is isolated: a library does not know what
/// program could be started in its host's name.
SPECBAKE_API void setIsolation(Isolation isolation, std::vector<std::string> program);

/// What the other process does: reads images for the one at the other end of that socket, until it
/// goes. Sets limits for itself.
SPECBAKE_API void serveIsolatedReads(int socket);

}  // namespace specbake
