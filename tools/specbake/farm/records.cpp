#include "farm/records.h"

#include "bake_report.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <array>
#include <fstream>
#include <system_error>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

std::string hostName() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

void makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder.string(), error.message());
}

}  // namespace

fs::path recordsFolder(const fs::path& results) {
    return results / ".specbake";
}

void Records::open() const {
    makeFolder(folder_);
}

bool Records::kept() const {
    std::error_code ignored;
    return fs::is_directory(folder_, ignored);
}

/// `failed/hull/wood.exr.json`, for `hull/wood.exr` among the results.
fs::path Records::fileOf(const BatchItem& item) const {
    const fs::path result = fs::absolute(item.output).lexically_normal();
    const fs::path results = fs::absolute(folder_).lexically_normal().parent_path();
    fs::path name = result.lexically_relative(results);
    if (name.empty() || *name.begin() == "..")
        name = fs::path("elsewhere") / result.relative_path();
    name += ".json";
    return folder_ / "failed" / name;
}

void Records::note(const BatchItem& item, const BatchResult& result) const {
    const fs::path file = fileOf(item);
    if (result.outcome == Outcome::failed) {
        nlohmann::ordered_json json = failureJson(item.input.path, item.output, result.reason);
        json["host"] = hostName();
        makeFolder(file.parent_path());
        writeWhole(file, jsonText(json, -1) + '\n');
    } else if (result.outcome == Outcome::baked || result.outcome == Outcome::current) {
        std::error_code ignored;
        fs::remove(file, ignored);
    }
}

std::optional<std::string> Records::failure(const BatchItem& item) const {
    const fs::path file = fileOf(item);
    std::error_code error;
    const auto told = fs::last_write_time(file, error);
    if (error) return {};
    const auto changed = fs::last_write_time(item.input.path, error);
    if (!error && changed > told) return {};
    std::ifstream in(file);
    const auto json = nlohmann::json::parse(in, nullptr, false);
    const auto reason = json.is_object() ? json.find("error") : json.end();
    return reason != json.end() && reason->is_string() ? reason->get<std::string>() : "it failed";
}

}  // namespace specbake::tool
