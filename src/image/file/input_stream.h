#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace specbake::internal {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A file of the C library, as the C libraries that unpack images want it.
using InputStream = std::unique_ptr<std::FILE, CloseFile>;

/// Whether a file begins with these bytes. False for a file that cannot be read.
bool beginsWith(const std::string& path, const std::string& signature);

/// Throws FileError.
InputStream openStream(const std::string& path);

}  // namespace specbake::internal
