#include "help/help_commands.h"

#include "help/completions.h"
#include "help/manual.h"
#include "help/option_facts.h"

#include <specbake/core/error.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace specbake::tool {
namespace {

const CLI::App* named(const CLI::App& program, const std::string& name) {
    if (name.empty()) return nullptr;
    for (const CLI::App* command : commandsOf(program)) {
        if (command->get_name() == name) return command;
    }
    throw ArgumentError("there is no command '" + name + "'");
}

}  // namespace

Command addCompletion(CLI::App& program) {
    auto shell = std::make_shared<std::string>();
    CLI::App* command =
        program.add_subcommand("completion", "A script that lets a shell complete command lines");
    command->add_option("shell", *shell, "bash, zsh or fish")->required();
    return [shell, &program] {
        std::fputs(completionScript(program, *shell).c_str(), stdout);
        return kDone;
    };
}

Command addManual(CLI::App& program) {
    auto name = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("manual", "A page for man(1)");
    command->add_option("command", *name, "the command that it is about; else all of them");
    return [name, &program] {
        std::fputs(manualPage(program, named(program, *name)).c_str(), stdout);
        return kDone;
    };
}

}  // namespace specbake::tool
