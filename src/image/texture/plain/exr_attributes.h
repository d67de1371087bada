#pragma once

#include <string>

namespace specbake::internal {

/// Throws FileError where an attribute of an EXR's headers cannot take what it claims to take, by
/// the file or by its type: OpenEXR's C++ reader (3.1.5) allocates by the claims, and where a type
/// says otherwise it reads on in the midst of a value. What else is wrong, the readers say.
void checkExrAttributes(const std::string& path);

}  // namespace specbake::internal
