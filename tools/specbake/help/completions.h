#pragma once

#include "cli_declared.h"

#include <string>

namespace specbake::tool {

/// A script that lets a shell complete commands, options and their words: "bash", "zsh" or "fish".
/// Everything else is completed as names of files. Throws ArgumentError for another shell.
std::string completionScript(const CLI::App& program, const std::string& shell);

}  // namespace specbake::tool
