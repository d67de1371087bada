#pragma once

#include "cli_declared.h"

#include <string>
#include <vector>

/// What help in every form is made of, taken from the options themselves.
namespace specbake::tool {

struct OptionFacts {
    std::vector<std::string> names;    ///< "-o", "--output"; of a positional its name
    std::string value;                 ///< what stands for it: "FILE", "W H"; empty for a flag
    std::vector<std::string> choices;  ///< the words that it may be, if these are few
    std::string defaultValue;
    std::string description;
    std::string group;
};

OptionFacts factsOf(const CLI::Option& option);

/// Those that help shows.
std::vector<OptionFacts> optionsOf(const CLI::App& command);
std::vector<OptionFacts> positionalsOf(const CLI::App& command);

/// The commands that help shows.
std::vector<const CLI::App*> commandsOf(const CLI::App& program);
std::vector<std::string> commandNames(const CLI::App& program);

std::string joined(const std::vector<std::string>& words, const std::string& between);

}  // namespace specbake::tool
