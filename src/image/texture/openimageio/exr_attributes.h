#pragma once

#include <string>

namespace specbake::internal {

/// Whether the attributes of an EXR's headers take what they claim to take, by the file and by their
/// types: OpenEXR's C++ reader (3.1.5) allocates by the claims, and where a type says otherwise it
/// reads on in the midst of a value. What else is wrong with the file, the readers say. Throws
/// FileError.
void checkExrAttributes(const std::string& path);

}  // namespace specbake::internal
