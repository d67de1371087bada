#include "help/suggestions.h"

#include "help/option_facts.h"

#include <specbake/core/error.h>

#include <CLI/CLI.hpp>

#include <algorithm>

namespace specbake::tool {
namespace {

std::vector<std::string> optionNames(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

}  // namespace

std::optional<std::string> explainUnknown(const CLI::App& program,
                                          const std::vector<std::string>& words) {
    if (words.empty() || words.front().starts_with('-')) return {};
    const std::string& name = words.front();
    const auto found = program.get_subcommands(
        [&](const CLI::App* command) { return command->get_name() == name; });
    if (found.empty()) {
        return "there is no command '" + name + "'" + suggestion(name, commandNames(program));
    }
    const std::vector<std::string> options = optionNames(*found.front());
    for (const std::string& word : words) {
        if (word == "--") break;
        const std::string option = word.substr(0, word.find('='));
        const bool isKnown = std::find(options.begin(), options.end(), option) != options.end();
        if (!option.starts_with("--") || isKnown) continue;
        return std::string(name)
            .append(" has no option ")
            .append(option)
            .append(suggestion(option, options));
    }
    return {};
}

}  // namespace specbake::tool
