#pragma once

#include "cli_declared.h"

#include <functional>

namespace specbake::tool {

/// What the process returns.
enum ExitCode {
    kDone = 0,
    kFailed = 1,    ///< it could not be done: the file and the reason are on stderr
    kUsage = 2,     ///< the command was wrong
    kDifferent = 3  ///< `verify` found too large a difference
};

/// A subcommand adds itself to the program; what it returns does the work once the command line is
/// read.
using Command = std::function<ExitCode()>;

Command addBake(CLI::App& program);
Command addRegion(CLI::App& program);
Command addSolve(CLI::App& program);
Command addInspect(CLI::App& program);
Command addRelight(CLI::App& program);
Command addStatus(CLI::App& program);
Command addTable(CLI::App& program);
Command addVerify(CLI::App& program);

}  // namespace specbake::tool
