#include "help/manual.h"

#include "help/help_texts.h"
#include "help/option_facts.h"

#include <specbake/version.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace specbake::tool {
namespace {

/// A backslash, a hyphen, and a dot or quote at a line's start mean something to roff.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += "\\e";
        } else if (c == '-') {
            result += "\\-";
        } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
            result.append("\\&").push_back(c);
        } else {
            result += c;
        }
    }
    return result;
}

std::string described(const OptionFacts& option) {
    std::string text = fmt::format(".TP\n\\fB{}\\fR", escaped(joined(option.names, ", ")));
    if (!option.value.empty()) text += fmt::format(" \\fI{}\\fR", escaped(option.value));
    text += fmt::format("\n{}\n", escaped(option.description));
    if (!option.choices.empty()) {
        text += fmt::format("One of {}.\n", escaped(joined(option.choices, ", ")));
    }
    if (!option.defaultValue.empty()) {
        text += fmt::format("Default: {}.\n", escaped(option.defaultValue));
    }
    return text;
}

std::string optionsByGroup(const CLI::App& command) {
    std::string text;
    const auto options = optionsOf(command);
    for (const std::string& group : groupsOf(command)) {
        text += fmt::format(".SS \"{}\"\n", escaped(group));
        for (const OptionFacts& option : options) {
            if (option.group == group) text += described(option);
        }
    }
    return text;
}

/// Lines that begin with spaces are shown as they are.
std::string footerOf(const CLI::App& app) {
    std::string text;
    std::istringstream in(app.get_footer());
    for (std::string line; std::getline(in, line);) {
        if (line.empty()) {
            text += ".PP\n";
        } else {
            text += fmt::format("{}{}\n", line.starts_with(' ') ? ".br\n\\&" : "", escaped(line));
        }
    }
    return text.empty() ? "" : fmt::format(".SH NOTES\n{}", text);
}

std::string head(const std::string& name, const std::string& description) {
    std::string title = name;
    std::transform(title.begin(), title.end(), title.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
    return fmt::format(".TH \"{}\" 1 \"\" \"specbake {}\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
                       escaped(title), kVersion, escaped(name), escaped(description));
}

std::string commandPage(const CLI::App& command) {
    const std::string& name = command.get_name();
    std::string page = head("specbake-" + name, command.get_description());
    page += fmt::format("\\fBspecbake {}\\fR", name);
    std::string arguments;
    for (const OptionFacts& positional : positionalsOf(command)) {
        page += fmt::format(" \\fI{}\\fR", escaped(positional.names.front()));
        arguments += described(positional);
    }
    page += " [\\fIOPTION\\fR ...]\n";
    if (!arguments.empty()) page += ".SH ARGUMENTS\n" + arguments;
    return page + ".SH OPTIONS\n" + optionsByGroup(command) + footerOf(command) +
           ".SH SEE ALSO\n.BR specbake (1)\n";
}

}  // namespace

std::string manualPage(const CLI::App& program, const CLI::App* command) {
    if (command != nullptr) return commandPage(*command);
    std::string page = head("specbake", program.get_description());
    page += "\\fBspecbake\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR ...]\n.SH COMMANDS\n";
    for (const CLI::App* each : commandsOf(program)) {
        page += fmt::format(".TP\n\\fBspecbake\\-{}\\fR(1)\n{}\n", each->get_name(),
                            escaped(each->get_description()));
    }
    return page + footerOf(program);
}

}  // namespace specbake::tool
