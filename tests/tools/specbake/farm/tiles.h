#pragma once

#include "process.h"

#include <cstdint>
#include <string>
#include <vector>

namespace specbake::testing {

/// PNGs in a folder, their list, and a folder for the results.
struct Tiles {
    /// `sides`: a tile of w by h pixels each.
    explicit Tiles(const std::vector<std::pair<int, int>>& sides);

    std::string name(std::size_t tile) const;  ///< of the texture
    std::string result(std::size_t tile) const;
    void write(std::size_t tile, int width, int height) const;

    /// Of `specbake COMMAND @list -o OUT OPTIONS...`
    std::vector<std::string> words(const std::string& command,
                                   const std::vector<std::string>& options = {}) const;

    Scratch scratch;
    std::string out = scratch.path("out");
    std::vector<std::uint64_t> pixels;
};

/// An environment variable that is set as long as this object lives; programs that are run then
/// have it.
class SetVariable {
  public:
    SetVariable(std::string name, const std::string& value);
    ~SetVariable();
    SetVariable(const SetVariable&) = delete;
    SetVariable& operator=(const SetVariable&) = delete;

  private:
    std::string name_;
};

/// The tiles that a bake went through, by the lines of its `--stats -`, with what became of them.
std::vector<std::pair<std::size_t, std::string>> throughOf(const Tiles& tiles,
                                                           const std::string& stats);

}  // namespace specbake::testing
