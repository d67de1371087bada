#pragma once

#include "cli_declared.h"

#include <optional>
#include <string>
#include <vector>

namespace specbake::tool {

/// What is wrong with a command line that could not be read, if it is a command or an option that
/// is not there: one line with what was probably meant. Nothing if it is something else.
std::optional<std::string> explainUnknown(const CLI::App& program,
                                          const std::vector<std::string>& words);

}  // namespace specbake::tool
