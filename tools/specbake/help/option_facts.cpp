#include "help/option_facts.h"

#include <CLI/CLI.hpp>

#include <sstream>

namespace specbake::tool {
namespace {

/// Of "TEXT:{a,b,c}", what a check of membership makes of a type's name.
std::vector<std::string> choicesIn(const std::string& type) {
    const std::size_t begin = type.find('{');
    const std::size_t end = type.find('}');
    if (begin == std::string::npos || end == std::string::npos) return {};
    std::vector<std::string> choices;
    std::istringstream in(type.substr(begin + 1, end - begin - 1));
    for (std::string choice; std::getline(in, choice, ',');) choices.push_back(choice);
    return choices;
}

std::vector<OptionFacts> factsOfAll(const CLI::App& command, bool positional) {
    std::vector<OptionFacts> all;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional() == positional && !option->get_group().empty()) {
            all.push_back(factsOf(*option));
        }
    }
    return all;
}

}  // namespace

OptionFacts factsOf(const CLI::Option& option) {
    OptionFacts facts;
    for (const std::string& name : option.get_snames()) facts.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) facts.names.push_back("--" + name);
    if (facts.names.empty()) facts.names.push_back(option.get_name());
    if (option.get_type_size() != 0) {
        const std::string type = option.get_type_name();
        facts.choices = choicesIn(type);
        facts.value = facts.choices.empty() ? type.substr(0, type.find(':')) : "WORD";
        facts.defaultValue = option.get_default_str();
    }
    facts.description = option.get_description();
    facts.group = option.get_group();
    return facts;
}

std::vector<OptionFacts> optionsOf(const CLI::App& command) {
    return factsOfAll(command, false);
}

std::vector<OptionFacts> positionalsOf(const CLI::App& command) {
    return factsOfAll(command, true);
}

std::vector<const CLI::App*> commandsOf(const CLI::App& program) {
    return program.get_subcommands(
        [](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> commandNames(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : commandsOf(program)) names.push_back(command->get_name());
    return names;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

}  // namespace specbake::tool
