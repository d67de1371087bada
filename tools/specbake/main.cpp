#include "commands.h"
#include "guard/isolated_reader.h"
#include "guard/streams.h"
#include "help/help_commands.h"
#include "help/help_formatter.h"
#include "help/help_texts.h"
#include "help/option_facts.h"
#include "help/suggestions.h"
#include "help/version_text.h"
#include "stop_signals.h"

#include <specbake/core/error.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <string>

using namespace specbake;
using namespace specbake::tool;

namespace {

ExitCode run(int argc, char** argv) {
    CLI::App program("specbake: XYZ and RGB textures to spectral textures", "specbake");
    program.set_version_flag("--version", versionText());
    program.require_subcommand(1);
    program.formatter(std::make_shared<HelpFormatter>());
    program.failure_message([](const CLI::App*, const CLI::Error& error) {
        return std::string("specbake: ") + error.what() + " (--help tells more)\n";
    });
    program.footer(
        "specbake COMMAND --help tells more. Exit codes: 0 done, 1 it could not be done,\n"
        "2 the command was wrong, 3 verify found too large a difference.");
    const std::map<std::string, Command> commands = {{"bake", addBake(program)},
                                                     {"solve", addSolve(program)},
                                                     {"region", addRegion(program)},
                                                     {"inspect", addInspect(program)},
                                                     {"relight", addRelight(program)},
                                                     {"status", addStatus(program)},
                                                     {"table", addTable(program)},
                                                     {"verify", addVerify(program)},
                                                     {"completion", addCompletion(program)},
                                                     {"manual", addManual(program)}};
    addHelpTexts(program);
    if (argc == 1) {
        throw ArgumentError("a command is wanted: " + joined(commandNames(program), ", ") +
                            " (--help tells more)");
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const auto unknown = explainUnknown(program, {argv + 1, argv + argc});
        if (unknown && error.get_exit_code() != 0) {
            throw ArgumentError(*unknown + " (--help tells more)");
        }
        return program.exit(error) == 0 ? kDone : kUsage;
    }
    return commands.at(program.get_subcommands().front()->get_name())();
}

ExitCode fail(const char* what, ExitCode code) {
    std::fprintf(stderr, "specbake: %s\n", shown(what).c_str());
    return code;
}

ExitCode runToTheEnd(int argc, char** argv) {
    const StopSignals signals;
    try {
        const ExitCode code = run(argc, argv);
        finishStdout();
        StopSignals::passOn();
        return code;
    } catch (...) {
        StopSignals::passOn();
        throw;
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        openStandardStreams();
        if (isIsolatedReader(argc, argv)) return serveReads();
        isolate(Isolation::automatic);
        return runToTheEnd(argc, argv);
    } catch (const ArgumentError& error) {
        return fail(error.what(), kUsage);
    } catch (const Error& error) {
        return fail(error.what(), kFailed);
    } catch (const std::bad_alloc&) {
        return fail("not enough memory", kFailed);
    } catch (const std::exception& error) {
        return fail(error.what(), kFailed);
    }
}
