#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace specbake::tool {

/// The command line's help, never wider than the terminal: an option's words, and below or beside
/// them what it does.
class HelpFormatter : public CLI::Formatter {
  public:
    std::string make_usage(const CLI::App* app, std::string name) const override;
    std::string make_description(const CLI::App* app) const override;
    std::string make_footer(const CLI::App* app) const override;
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;
    std::string make_option(const CLI::Option* option, bool positional) const override;
    std::string make_option_opts(const CLI::Option* option) const override;
    std::string make_subcommand(const CLI::App* command) const override;

  private:
    std::string optionsByGroup(const CLI::App& command) const;
};

}  // namespace specbake::tool
