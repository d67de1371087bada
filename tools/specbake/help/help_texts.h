#pragma once

#include "cli_declared.h"

#include <string>
#include <vector>

namespace specbake::tool {

/// Sorts the options of a program's commands into groups by their names, and gives each command its
/// examples. What is not known here stands under "Options".
void addHelpTexts(CLI::App& program);

/// The groups of a command's options, in the order of help.
std::vector<std::string> groupsOf(const CLI::App& command);

}  // namespace specbake::tool
