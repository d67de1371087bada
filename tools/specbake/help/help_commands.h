#pragma once

#include "commands.h"

namespace specbake::tool {

/// `completion SHELL` and `manual [COMMAND]`: what the build installs of them, to standard output.
Command addCompletion(CLI::App& program);
Command addManual(CLI::App& program);

}  // namespace specbake::tool
