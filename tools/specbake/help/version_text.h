#pragma once

#include <string>

namespace specbake::tool {

/// "specbake 0.1.0 (fe3ebf259b6c)": the version, and the commit that the program was built of.
std::string versionText();

}  // namespace specbake::tool
