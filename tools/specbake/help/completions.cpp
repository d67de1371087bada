#include "help/completions.h"

#include "help/option_facts.h"

#include <specbake/core/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace specbake::tool {
namespace {

/// Within '…' of a shell.
std::string singleQuoted(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else {
            result += c;
        }
    }
    return result;
}

/// For each command its options, and for each option with choices these.
std::string bashScript(const CLI::App& program) {
    std::string options;
    std::string values;
    for (const CLI::App* command : commandsOf(program)) {
        std::vector<std::string> names;
        for (const OptionFacts& option : optionsOf(*command)) {
            names.insert(names.end(), option.names.begin(), option.names.end());
            if (option.choices.empty()) continue;
            for (const std::string& name : option.names) {
                values += fmt::format("        {}:{}) words='{}' ;;\n", command->get_name(), name,
                                      singleQuoted(joined(option.choices, " ")));
            }
        }
        options +=
            fmt::format("        {}) words='{}' ;;\n", command->get_name(), joined(names, " "));
    }
    return "_specbake() {\n"
           "    local words='' word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}\n"
           "    case \"$command:${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
           values +
           "    esac\n"
           "    if [ -z \"$words\" ] && [ \"$COMP_CWORD\" -eq 1 ]; then\n"
           "        words='" +
           joined(commandNames(program), " ") +
           " --help --version'\n"
           "    elif [ -z \"$words\" ] && [[ $word == -* ]]; then\n"
           "        case \"$command\" in\n" +
           options +
           "        esac\n"
           "    fi\n"
           "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
           "}\n"
           "complete -o default -F _specbake specbake\n";
}

/// Colons and brackets divide what _arguments takes.
std::string forArguments(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == ':' || c == '[' || c == ']') result += '\\';
        result += c;
    }
    return singleQuoted(result);
}

std::string zshScript(const CLI::App& program) {
    std::string commands;
    std::string cases;
    for (const CLI::App* command : commandsOf(program)) {
        commands += fmt::format("        '{}:{}'\n", command->get_name(),
                                singleQuoted(command->get_description()));
        cases += fmt::format("        {}) _arguments", command->get_name());
        for (const OptionFacts& option : optionsOf(*command)) {
            for (const std::string& name : option.names) {
                cases +=
                    fmt::format(" \\\n            '{}[{}]", name, forArguments(option.description));
                if (!option.choices.empty()) {
                    cases += fmt::format(":word:({})", joined(option.choices, " "));
                } else if (!option.value.empty()) {
                    cases += ":value:_files";
                }
                cases += "'";
            }
        }
        cases += " \\\n            '*:file:_files' ;;\n";
    }
    return "#compdef specbake\n"
           "_specbake() {\n"
           "    local -a commands=(\n" +
           commands +
           "    )\n"
           "    if (( CURRENT == 2 )); then\n"
           "        _describe command commands\n"
           "        return\n"
           "    fi\n"
           "    local command=$words[2]\n"
           "    shift words\n"
           "    (( CURRENT-- ))\n"
           "    case $command in\n" +
           cases +
           "    esac\n"
           "}\n"
           "_specbake \"$@\"\n";
}

std::string fishScript(const CLI::App& program) {
    std::string text;
    for (const CLI::App* command : commandsOf(program)) {
        text += fmt::format("complete -c specbake -f -n __fish_use_subcommand -a {} -d '{}'\n",
                            command->get_name(), singleQuoted(command->get_description()));
        for (const OptionFacts& option : optionsOf(*command)) {
            text += fmt::format("complete -c specbake -n '__fish_seen_subcommand_from {}'",
                                command->get_name());
            for (const std::string& name : option.names) {
                const bool isLong = name.starts_with("--");
                text += fmt::format(" -{} {}", isLong ? 'l' : 's', name.substr(isLong ? 2 : 1));
            }
            if (!option.choices.empty()) {
                text += fmt::format(" -x -a '{}'", singleQuoted(joined(option.choices, " ")));
            } else if (!option.value.empty()) {
                text += " -r";
            }
            text += fmt::format(" -d '{}'\n", singleQuoted(option.description));
        }
    }
    return text;
}

}  // namespace

std::string completionScript(const CLI::App& program, const std::string& shell) {
    if (shell == "bash") return bashScript(program);
    if (shell == "zsh") return zshScript(program);
    if (shell == "fish") return fishScript(program);
    throw ArgumentError("no completions for '" + shell + "', but for bash, zsh and fish");
}

}  // namespace specbake::tool
