#include "batch/output_names.h"

#include "batch/number_token.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <filesystem>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

bool isPattern(const std::string& output) {
    return output.find_first_of("{}") != std::string::npos;
}

}  // namespace

OutputNames::OutputNames(std::string output, std::string extension, std::string option)
    : output_(std::move(output)), extension_(std::move(extension)), option_(std::move(option)) {
    if (!namesMany()) {
        throw ArgumentError(option_ + " " + output_ +
                            ": several textures need a folder, or a pattern such as "
                            "'{dir}/{stem}.spectral" +
                            extension_ + "'");
    }
}

bool OutputNames::namesMany() const {
    std::error_code ignored;
    return isPattern(output_) || findNumberToken(output_) || fs::is_directory(output_, ignored) ||
           fs::path(output_).extension() != extension_;
}

std::string OutputNames::numberOf(const Input& input) const {
    if (!input.number.empty()) return input.number;
    throw ArgumentError(option_ + ": " + input.path +
                        " has no number: name the tiles or frames by a pattern, as in "
                        "'wood.<UDIM>.png'");
}

std::string OutputNames::fieldOf(const Input& input, const std::string& field) const {
    const fs::path path(input.path);
    if (field == "dir") return path.has_parent_path() ? path.parent_path().string() : ".";
    if (field == "tree") return input.tree.empty() ? "." : input.tree;
    if (field == "name") return path.filename().string();
    if (field == "stem") return path.stem().string();
    if (field == "ext") return path.has_extension() ? path.extension().string().substr(1) : "";
    if (field == "number") return numberOf(input);
    throw ArgumentError(option_ + ": there is no {" + field +
                        "}, but {dir}, {tree}, {name}, {stem}, {ext} and {number}");
}

/// With the fields of the input in their places.
std::string OutputNames::filled(const Input& input) const {
    std::string name;
    for (std::size_t at = 0; at < output_.size(); ++at) {
        const char c = output_[at];
        const bool twice = at + 1 < output_.size() && output_[at + 1] == c;
        if (c != '{' && c != '}') {
            name += c;
        } else if (twice) {
            name += output_[at++];
        } else {
            const std::size_t end = c == '{' ? output_.find('}', at) : std::string::npos;
            if (end == std::string::npos) {
                throw ArgumentError(option_ + ": a brace without its other half: " + output_);
            }
            name += fieldOf(input, output_.substr(at + 1, end - at - 1));
            at = end;
        }
    }
    return name;
}

std::string OutputNames::nameFor(const Input& input) const {
    if (isPattern(output_)) return fs::path(filled(input)).lexically_normal().string();
    if (const auto token = findNumberToken(output_)) {
        std::string name = output_;
        return name.replace(token->begin, token->length, numberOf(input));
    }
    const fs::path path(input.path);
    return (fs::path(output_) / input.tree / (path.stem().string() + extension_)).string();
}

std::string OutputNames::folder() const {
    const auto token = isPattern(output_) ? std::nullopt : findNumberToken(output_);
    if (!isPattern(output_) && !token) return output_;
    const std::size_t end = token ? token->begin : output_.find_first_of("{}");
    const std::size_t slash = output_.substr(0, end).rfind('/');
    if (slash == std::string::npos) return ".";
    return output_.substr(0, std::max(slash, std::size_t(1)));
}

}  // namespace specbake::tool
