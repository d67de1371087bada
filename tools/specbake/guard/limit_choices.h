#pragma once

#include "cli_declared.h"

/// Options by which a command does more than usual that nothing is lost, or takes less than there
/// is.
namespace specbake::tool {

/// `--sync`
void addSync(CLI::App& command, bool& sync);

/// `--max-pixels`, `--max-memory`: they set the limits() of the process while the command line is
/// read.
void addLimits(CLI::App& command);

/// `--isolate`: it sets what is isolated while the command line is read.
void addIsolation(CLI::App& command);

}  // namespace specbake::tool
