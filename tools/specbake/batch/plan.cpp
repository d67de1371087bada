#include "batch/plan.h"

#include <specbake/core/error.h>
#include <specbake/image/exr_text.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

/// The same for every name of a file, whether it is there yet or not.
fs::path identified(const std::string& name) {
    std::error_code ignored;
    const fs::path path = fs::weakly_canonical(name, ignored);
    return path.empty() ? fs::absolute(name).lexically_normal() : path;
}

bool isPassedOver(const Input& input) {
    return input.found && exrText(input.path, "spectralLayoutVersion").has_value();
}

}  // namespace

void checkSpectralName(const std::string& output) {
    std::string extension = fs::path(output).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    if (extension != ".exr") {
        throw ArgumentError(output + ": a spectral image is an EXR; its name must end in .exr");
    }
}

std::vector<BatchItem> planBatch(std::vector<Input> inputs, const OutputNames& names) {
    std::set<fs::path> textures;
    std::vector<BatchItem> items;
    for (Input& input : inputs) {
        const bool passed = isPassedOver(input);
        if (!passed) textures.insert(identified(input.path));
        std::string output = passed ? "" : names.nameFor(input);
        items.push_back({std::move(input), std::move(output)});
    }
    std::map<fs::path, std::string> madeOf;
    for (const auto& [input, output] : items) {
        if (output.empty()) continue;
        checkSpectralName(output);
        const fs::path path = identified(output);
        if (textures.count(path) > 0) throw ArgumentError(output + ": the output is an input");
        const auto [other, isNew] = madeOf.emplace(path, input.path);
        if (!isNew) {
            throw ArgumentError(output + ": both " + other->second + " and " + input.path +
                                " would become this file; name the results by a pattern such as "
                                "'OUT/{tree}/{name}.exr'");
        }
    }
    return items;
}

}  // namespace specbake::tool
