#include "batch/plan.h"

#include "guard/file_names.h"

#include <specbake/core/error.h>
#include <specbake/image/exr_text.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

bool isPassedOver(const Input& input) {
    return input.found && exrText(input.path, "spectralLayoutVersion").has_value();
}

/// Which textures are read, and which of them becomes which file.
class BatchNames {
  public:
    void addTexture(const std::string& name) { textures_.insert(identified(name)); }

    /// Throws ArgumentError if it is a texture, or what another texture becomes.
    void addResult(const std::string& name, const std::string& texture) {
        const fs::path path = identified(name);
        if (textures_.count(path) > 0) throw ArgumentError(name + ": the output is an input");
        const auto [other, isNew] = madeOf_.emplace(path, texture);
        if (isNew) return;
        throw ArgumentError(name + ": both " + other->second + " and " + texture +
                            " would become this file; name the results by a pattern such as "
                            "'OUT/{tree}/{name}" +
                            path.extension().string() + "'");
    }

  private:
    std::set<fs::path> textures_;
    std::map<fs::path, std::string> madeOf_;
};

}  // namespace

void checkSpectralName(const std::string& output) {
    std::string extension = fs::path(output).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    if (extension != ".exr") {
        throw ArgumentError(output + ": a spectral image is an EXR; its name must end in .exr");
    }
}

std::vector<BatchItem> planBatch(std::vector<Input> inputs, const OutputNames& names,
                                 const std::optional<OutputNames>& pages) {
    BatchNames files;
    std::vector<BatchItem> items;
    for (Input& input : inputs) {
        BatchItem item{std::move(input), {}, {}};
        if (!isPassedOver(item.input)) {
            files.addTexture(item.input.path);
            item.output = names.nameFor(item.input);
            if (pages) item.page = pages->nameFor(item.input);
        }
        items.push_back(std::move(item));
    }
    for (const BatchItem& item : items) {
        if (item.output.empty()) continue;
        checkSpectralName(item.output);
        files.addResult(item.output, item.input.path);
        if (pages) files.addResult(item.page, item.input.path);
    }
    return items;
}

}  // namespace specbake::tool
