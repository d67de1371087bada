#include "help/help_formatter.h"

#include "help/help_texts.h"
#include "help/wrapped_text.h"

#include <sstream>

namespace specbake::tool {
namespace {

constexpr std::size_t kNames = 2;          ///< the column of an option's words
constexpr std::size_t kDescriptions = 22;  ///< that of what it does
constexpr std::size_t kContinued = 6;      ///< that of more of its words

/// Two columns; the second on a line of its own where the first is too long.
std::string entry(const std::string& words, const std::string& description) {
    const std::size_t width = textWidth();
    const std::size_t indent = width < 60 ? kContinued + 2 : kDescriptions;
    std::string text(kNames, ' ');
    text += wrapped(words, width, kNames, kContinued);
    if (description.empty()) return text + '\n';
    if (kNames + words.size() + 2 <= indent) {
        text.resize(indent, ' ');
    } else {
        text += '\n' + std::string(indent, ' ');
    }
    return text + wrapped(description, width, indent, indent) + '\n';
}

/// Lines that begin with spaces stay lines; the others flow together until an empty one.
std::string paragraphs(const std::string& text) {
    std::string result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
        result += std::string(indent, ' ') +
                  wrapped(line.substr(indent), textWidth(), indent, indent > 0 ? indent + 4 : 0) +
                  '\n';
    }
    return result;
}

/// Of "INT:INT in [4 - 10]" and "TEXT:{half,float}" what stands behind the colon, of
/// "FLOAT:POSITIVE" what stands before it.
std::string shortType(const std::string& type) {
    const std::size_t colon = type.find(':');
    if (colon == std::string::npos) return type;
    const std::string check = type.substr(colon + 1);
    const bool tells = check.starts_with('{') || check.find(" in [") != std::string::npos;
    return tells ? check : type.substr(0, colon);
}

}  // namespace

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
    const std::string usage = Formatter::make_usage(app, std::move(name));
    return '\n' + wrapped(usage, textWidth(), 0, kContinued) + '\n';
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
    return paragraphs(app->get_description());
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
    return paragraphs(app->get_footer());
}

/// CLI11's own order of groups is that in which options were added, --help first.
std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
    if (mode == CLI::AppFormatMode::Sub) return Formatter::make_help(app, std::move(name), mode);
    return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
           optionsByGroup(*app) + make_subcommands(app, mode) + '\n' + make_footer(app);
}

std::string HelpFormatter::optionsByGroup(const CLI::App& command) const {
    std::string text;
    for (const std::string& group : groupsOf(command)) {
        const auto options = command.get_options([&](const CLI::Option* option) {
            return option->nonpositional() && option->get_group() == group;
        });
        if (!options.empty()) text += make_group(group, false, options);
    }
    return text;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool positional) const {
    return entry(make_option_name(option, positional) + make_option_opts(option),
                 make_option_desc(option));
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
    std::string text;
    if (option->get_type_size() != 0) {
        const std::string type = shortType(option->get_type_name());
        if (!type.empty()) text += " " + type;
        if (!option->get_default_str().empty()) text += " (" + option->get_default_str() + ")";
    }
    if (!option->get_envname().empty()) text += " ($" + option->get_envname() + ")";
    return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
    return entry(command->get_name(), command->get_description());
}

}  // namespace specbake::tool
