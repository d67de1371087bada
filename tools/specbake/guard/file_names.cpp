#include "guard/file_names.h"

#include <specbake/core/error.h>

#include <sys/stat.h>

#include <optional>
#include <vector>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

std::vector<std::string>& noted() {
    static std::vector<std::string> names;
    return names;
}

std::optional<std::pair<dev_t, ino_t>> nodeOf(const std::string& name) {
    struct stat status {};
    if (stat(name.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return std::pair(status.st_dev, status.st_ino);
}

}  // namespace

void noteInput(const std::string& name) {
    noted().push_back(name);
}

fs::path identified(const std::string& name) {
    std::error_code ignored;
    const fs::path path = fs::weakly_canonical(name, ignored);
    return path.empty() ? fs::absolute(name).lexically_normal() : path;
}

FileNames::FileNames() {
    for (const std::string& name : noted()) addInput(name);
}

bool FileNames::isInput(const std::string& name) const {
    if (inputs_.contains(identified(name))) return true;
    const auto node = nodeOf(name);
    return node && inputNodes_.contains(*node);
}

void FileNames::addInput(const std::string& name) {
    if (name.empty()) return;
    inputs_.insert(identified(name));
    if (const auto node = nodeOf(name)) inputNodes_.insert(*node);
}

void FileNames::addOutput(const std::string& name, const std::string& option) {
    if (name.empty() || name == "-") return;
    if (isInput(name)) {
        throw ArgumentError(name + ": the output is the input" +
                            (option == "-o" ? "" : " (" + option + ")"));
    }
    const auto [other, isNew] = outputs_.emplace(identified(name), option);
    if (isNew) return;
    throw ArgumentError(name + ": both " + other->second + " and " + option + " would write it");
}

}  // namespace specbake::tool
