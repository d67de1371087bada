#include "farm/status.h"

#include "batch/run.h"
#include "batch/side_by_side.h"

#include <specbake/bake/model_cache.h>
#include <specbake/image/output_file.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <numeric>
#include <set>
#include <system_error>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

ItemStatus statusOf(const BatchItem& item, const BakeOptions& options, SourceCheck check) {
    std::error_code ignored;
    try {
        const auto reason = outdated(item.input.path, item.output, options, check);
        if (!reason) return {Standing::done, {}};
        if (!fs::exists(item.input.path, ignored)) return {Standing::failed, "it is not there"};
        if (!fs::exists(item.output, ignored)) return {};
        return {Standing::outdated, *reason};
    } catch (const std::exception& error) {
        return {Standing::failed, reasonOf(error, item.input.path)};
    }
}

}  // namespace

const char* standingName(Standing standing) {
    switch (standing) {
        case Standing::done:
            return "done";
        case Standing::missing:
            return "missing";
        case Standing::outdated:
            return "out of date";
        case Standing::failed:
            break;
    }
    return "failed";
}

std::vector<ItemStatus> statusOf(std::span<const BatchItem> items, BakeOptions options,
                                 SourceCheck check, const Records& records) {
    if (!options.models) options.models = std::make_shared<ModelCache>();
    std::vector<ItemStatus> all(items.size());
    std::vector<std::size_t> numbers(items.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
    sideBySide(numbers, options.threads, [&](std::size_t i) {
        all[i] = statusOf(items[i], options, check);
        const bool open = all[i].standing != Standing::done;
        if (const auto reason = open ? records.failure(items[i]) : std::nullopt) {
            all[i] = {Standing::failed, *reason};
        }
    });
    return all;
}

std::vector<fs::path> leftovers(std::span<const BatchItem> items) {
    std::set<fs::path> folders;
    for (const BatchItem& item : items) folders.insert(fs::path(item.output).parent_path());
    std::vector<fs::path> found;
    for (const fs::path& folder : folders) {
        std::error_code error;
        fs::directory_iterator file(folder.empty() ? "." : folder, error);
        for (; !error && file != fs::directory_iterator(); file.increment(error)) {
            if (OutputFile::isTemporary(file->path())) found.push_back(file->path());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace specbake::tool
