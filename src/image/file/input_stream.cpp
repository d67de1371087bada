#include "file/input_stream.h"

#include <specbake/core/error.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace specbake::internal {

bool beginsWith(const std::string& path, const std::string& signature) {
    std::string first(signature.size(), '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(first.data(), std::streamsize(first.size()));
    return in && first == signature;
}

InputStream openStream(const std::string& path) {
    InputStream stream(std::fopen(path.c_str(), "rb"));
    if (!stream) throw FileError(path, std::strerror(errno));
    return stream;
}

}  // namespace specbake::internal
