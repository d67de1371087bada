#include "guard/limit_choices.h"

#include "guard/isolated_reader.h"

#include <specbake/image/isolation.h>
#include <specbake/image/limits.h>

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace specbake::tool {
namespace {

/// "4096", "4k", "1.5G": powers of 1000 behind a number. Nothing for what is none, or not above 0.
std::optional<std::uint64_t> amount(std::string_view text) {
    constexpr std::string_view units = "kMGT";
    double factor = 1;
    const auto unit = text.empty() ? std::string_view::npos : units.find(text.back());
    if (unit != std::string_view::npos) {
        for (std::size_t i = 0; i <= unit; ++i) factor *= 1000;
        text.remove_suffix(1);
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr double most = 1e18;
    const double number = value * factor;
    const bool read = error == std::errc() && end == text.data() + text.size();
    if (!read || !(number >= 1 && number <= most)) return {};
    return std::uint64_t(number);
}

void addLimit(CLI::App& command, const std::string& name, std::uint64_t Limits::*limit,
              const std::string& description, const std::string& usual) {
    const auto set = [name, limit](const std::string& text) {
        const auto number = amount(text);
        if (!number) throw CLI::ValidationError(name, text + " is no amount such as 4096 or 1.5G");
        Limits all = limits();
        all.*limit = *number;
        setLimits(all);
    };
    command.add_option_function<std::string>(name, set, description)
        ->type_name("N[kMGT]")
        ->default_str(usual);
}

}  // namespace

void addSync(CLI::App& command, bool& sync) {
    command.add_flag("--sync", sync,
                     "wait until the disk has what is written, so that it outlives a power cut");
}

void addLimits(CLI::App& command) {
    addLimit(command, "--max-pixels", &Limits::pixels, "refuse images of more pixels", "4.29G");
    addLimit(command, "--max-memory", &Limits::memory,
             "bytes that reading an image, and the rows under way, may take: fewer rows are under "
             "way then, and what needs more is refused",
             "17.2G");
}

void addIsolation(CLI::App& command) {
    command
        .add_option_function<std::string>(
            "--isolate", [](const std::string& name) { isolate(isolationFromName(name).value()); },
            "which images are read in a process of their own, whose crash is an error of that "
            "image: all but PNG, JPEG, EXR and TIFF (auto), all or none")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->default_str("auto");
}

}  // namespace specbake::tool
