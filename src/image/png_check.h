#pragma once

#include <string>

namespace specbake {

/// Throws FileError if the file begins as a PNG and is not whole: chunks that end early or do not
/// have their checksum, no end, or sides that no texture has. libpng says so on stderr besides, and
/// not where all pixels are there. Other files pass.
void checkPng(const std::string& path);

}  // namespace specbake
