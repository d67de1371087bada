#include "help/version_text.h"

#include "revision.h"

#include <specbake/version.h>

namespace specbake::tool {

std::string versionText() {
    const std::string revision = SPECBAKE_REVISION;
    std::string text = "specbake ";
    text += kVersion;
    return revision.empty() ? text : text + " (" + revision + ")";
}

}  // namespace specbake::tool
