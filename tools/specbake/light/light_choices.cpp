#include "light/light_choices.h"

#include "guard/file_names.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/image/light_file.h>
#include <specbake/image/observer_file.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <vector>

namespace specbake::tool {
namespace {

bool namesFile(const std::string& light) {
    std::error_code ignored;
    return light.find_first_of("./") != std::string::npos ||
           std::filesystem::exists(light, ignored);
}

template <class Text>
void addObserverOption(CLI::App& command, Text& observer, const std::string& description) {
    command.add_option("--observer", observer, description)
        ->transform(knownObserver())
        ->type_name("2|10|FILE");
}

}  // namespace

/// Those that are offered; of the further ones the series.
std::string lightWords(bool automatic) {
    std::string words = automatic ? "{auto" : "{";
    for (const std::string& name : illuminantNames()) words += (words == "{" ? "" : ",") + name;
    return words + "}, F1-F12, F3.1-F3.15, HP1-HP5, LED-..., ID50, ID65 or FILE";
}

std::string lightFrom(const std::string& word) {
    if (isIlluminant(word)) return word;
    if (namesFile(word)) {
        noteInput(word);
        return readLight(word);
    }
    std::vector<std::string> names = illuminantNames();
    std::ranges::copy(furtherIlluminantNames(), std::back_inserter(names));
    throw ArgumentError("no light and no file is called '" + word + "'" + suggestion(word, names));
}

CLI::Validator knownLight(bool automatic) {
    const auto toLight = [automatic](std::string& word) {
        if (!automatic || word != "auto") word = lightFrom(word);
        return std::string();
    };
    return CLI::Validator(toLight, "");
}

CLI::Option* addLight(CLI::App& command, std::string& light, const std::string& description,
                      bool automatic) {
    return command.add_option("--illuminant", light, description)
        ->transform(knownLight(automatic))
        ->type_name(lightWords(automatic))
        ->capture_default_str();
}

CLI::Validator knownObserver() {
    const auto toObserver = [](std::string& word) {
        if (isObserver(word)) return std::string();
        if (!namesFile(word)) {
            throw ArgumentError("--observer: 2, 10 or a file with a table, not '" + word + "'");
        }
        noteInput(word);
        word = readObserver(word);
        return std::string();
    };
    return {toObserver, ""};
}

void addObserver(CLI::App& command, std::string& observer, const std::string& description) {
    addObserverOption(command, observer, description);
}

void addObserver(CLI::App& command, std::optional<std::string>& observer,
                 const std::string& description) {
    addObserverOption(command, observer, description);
}

std::string byWhom(std::string_view observer) {
    return observer == kUsualObserver ? "" : ", " + std::string(observer);
}

}  // namespace specbake::tool
