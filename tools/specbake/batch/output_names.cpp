#include "batch/output_names.h"

#include "batch/number_token.h"

#include <specbake/core/error.h>

#include <filesystem>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

bool isPattern(const std::string& output) {
    return output.find_first_of("{}") != std::string::npos;
}

std::string numberOf(const Input& input) {
    if (!input.number.empty()) return input.number;
    throw ArgumentError("--output: " + input.path +
                        " has no number: name the tiles or frames by a pattern, as in "
                        "'wood.<UDIM>.png'");
}

std::string fieldOf(const Input& input, const std::string& field) {
    const fs::path path(input.path);
    if (field == "dir") return path.has_parent_path() ? path.parent_path().string() : ".";
    if (field == "tree") return input.tree.empty() ? "." : input.tree;
    if (field == "name") return path.filename().string();
    if (field == "stem") return path.stem().string();
    if (field == "ext") return path.has_extension() ? path.extension().string().substr(1) : "";
    if (field == "number") return numberOf(input);
    throw ArgumentError("--output: there is no {" + field +
                        "}, but {dir}, {tree}, {name}, {stem}, {ext} and {number}");
}

/// With the fields of the input in their places.
std::string filled(const std::string& pattern, const Input& input) {
    std::string name;
    for (std::size_t at = 0; at < pattern.size(); ++at) {
        const char c = pattern[at];
        const bool twice = at + 1 < pattern.size() && pattern[at + 1] == c;
        if (c != '{' && c != '}') {
            name += c;
        } else if (twice) {
            name += pattern[at++];
        } else {
            const std::size_t end = c == '{' ? pattern.find('}', at) : std::string::npos;
            if (end == std::string::npos) {
                throw ArgumentError("--output: a brace without its other half: " + pattern);
            }
            name += fieldOf(input, pattern.substr(at + 1, end - at - 1));
            at = end;
        }
    }
    return name;
}

bool isFolder(const std::string& output) {
    std::error_code ignored;
    return fs::is_directory(output, ignored) || fs::path(output).extension() != ".exr";
}

}  // namespace

bool OutputNames::namesMany(const std::string& output) {
    return isPattern(output) || findNumberToken(output) || isFolder(output);
}

OutputNames::OutputNames(std::string output) : output_(std::move(output)) {
    if (!namesMany(output_)) {
        throw ArgumentError(output_ +
                            ": several textures need a folder, or a pattern such as "
                            "'{dir}/{stem}.spectral.exr'");
    }
}

std::string OutputNames::nameFor(const Input& input) const {
    if (isPattern(output_)) return fs::path(filled(output_, input)).lexically_normal().string();
    if (const auto token = findNumberToken(output_)) {
        std::string name = output_;
        return name.replace(token->begin, token->length, numberOf(input));
    }
    const fs::path path(input.path);
    return (fs::path(output_) / input.tree / (path.stem().string() + ".exr")).string();
}

}  // namespace specbake::tool
