#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace specbake::tool {

/// Notes a file that an option named and that was read already, such as a light's: FileNames knows
/// them all.
void noteInput(const std::string& name);

/// The same for every name of a file, whether it is there yet or not.
std::filesystem::path identified(const std::string& name);

/// The files of one command: what is written is neither an input, by whatever names, links or hard
/// links, nor another output.
class FileNames {
  public:
    FileNames();

    /// `name`: "" for none.
    void addInput(const std::string& name);

    /// `option`: the one that names it. Throws ArgumentError.
    void addOutput(const std::string& name, const std::string& option);

  private:
    using Node = std::pair<dev_t, ino_t>;

    bool isInput(const std::string& name) const;

    std::set<std::filesystem::path> inputs_;
    std::set<Node> inputNodes_;
    std::map<std::filesystem::path, std::string> outputs_;  ///< and the options that name them
};

}  // namespace specbake::tool
