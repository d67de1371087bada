#include "texture/openimageio/openimageio_parts.h"

#include <specbake/core/error.h>

#include <dlfcn.h>

namespace specbake::internal {
namespace {

/// The module is looked for along the program's run path, which the build and the installation
/// set. It stays loaded: nobody need know when its last image is closed.
const OpenImageIOParts* loadParts(const std::string& path) {
    void* module = dlopen(SPECBAKE_OPENIMAGEIO_MODULE, RTLD_LAZY | RTLD_LOCAL);
    void* function = module == nullptr ? nullptr : dlsym(module, "specbakeOpenImageIOParts");
    if (function == nullptr) {
        const char* reason = dlerror();
        throw FileError(path, std::string("needs OpenImageIO, which cannot be loaded: ") +
                                  (reason == nullptr ? "no reason given" : reason));
    }
    return reinterpret_cast<decltype(&specbakeOpenImageIOParts)>(function)();
}

}  // namespace

const OpenImageIOParts& openImageIOParts(const std::string& path) {
    static const OpenImageIOParts* parts = loadParts(path);
    parts->setLimits(limits());
    return *parts;
}

}  // namespace specbake::internal
