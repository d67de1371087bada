#pragma once

#include "cli_declared.h"

#include <string>

namespace specbake::tool {

/// The page of the program or of one of its commands for man(1), made of what its help is made of.
std::string manualPage(const CLI::App& program, const CLI::App* command);

}  // namespace specbake::tool
