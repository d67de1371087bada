#include "commands.h"

namespace specbake::bench {
namespace {

std::vector<std::string> joined(std::string first, const std::vector<std::string>& rest) {
    std::vector<std::string> all{std::move(first)};
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

}  // namespace

std::vector<std::string> Options::allReflectances() const {
    return joined(data + "/colorchecker_24.csv", reflectances);
}

std::vector<std::string> Options::allTextures() const {
    return joined(SPECBENCH_TEXTURE, textures);
}

std::string Options::commandLine(const std::string& command) const {
    std::string line = "specbench " + command + (full ? " --full" : "");
    if (!reflectances.empty()) line += " --reflectances";
    for (const std::string& path : reflectances) line += ' ' + path;
    if (!textures.empty()) line += " --textures";
    for (const std::string& path : textures) line += ' ' + path;
    return line;
}

}  // namespace specbake::bench
