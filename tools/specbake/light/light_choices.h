#pragma once

#include "cli_declared.h"

#include <optional>
#include <string>
#include <string_view>

/// Lights and observers, as words of the command line.
namespace specbake::tool {

/// Those that are offered, for help.
std::string lightWords(bool automatic);

/// The name of a light, or the light in the file of that name, as a text that stands for a name
/// everywhere (lightText()). Throws ArgumentError, FileError.
std::string lightFrom(const std::string& word);

/// A check of a light's name that takes it from a file, where it names one.
CLI::Validator knownLight(bool automatic);

/// `--illuminant`: what lightFrom() takes. `automatic`: whether it may be "auto", too.
CLI::Option* addLight(CLI::App& command, std::string& light, const std::string& description,
                      bool automatic);

/// A check of an observer's name or angle that takes a table from a file, where it names one.
CLI::Validator knownObserver();

/// `--observer`: 2, 10 or a file.
void addObserver(CLI::App& command, std::string& observer, const std::string& description);
void addObserver(CLI::App& command, std::optional<std::string>& observer,
                 const std::string& description);

/// ", CIE 1964 10 degree" of a label; empty for the usual observer.
std::string byWhom(std::string_view observer);

}  // namespace specbake::tool
