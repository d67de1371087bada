#pragma once

#include <string>

namespace specbake::tool {

/// Puts something that fails in the place of standard streams that are closed: else the next file
/// that is opened would be taken for them. Call it before anything is opened.
void openStandardStreams();

/// Throws FileError if not all that was printed got through to standard output.
void finishStdout();

/// In one line, whatever is in it: control characters as C writes them.
std::string shown(const std::string& text);

}  // namespace specbake::tool
