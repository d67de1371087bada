#include "commands.h"

#include <specbake/core/error.h>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace specbake::bench {
namespace {

/// Runs a program and waits for it: its exit status, or -1 if it could not be run.
int run(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) {
        return -1;
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return -1;
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Debian's own interpreter: it is the one that has python3-matplotlib.
constexpr const char* kPython = "/usr/bin/python3";

}  // namespace

void runCharts(const Options& options) {
    if (run({kPython, "-c", "import matplotlib"}) != 0) {  // not found out at the end
        throw Error("the charts need Debian's python3-matplotlib");
    }
    runSpectra(options);
    runNature(options);
    runScene(options);
    runStability(options);
    runAccuracy(options);
    if (run({kPython, SPECBENCH_PLOT, options.out, options.charts}) != 0) {
        throw Error("the charts were not drawn");
    }
}

}  // namespace specbake::bench
