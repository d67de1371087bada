#pragma once

#include "batch/plan.h"
#include "batch/run.h"

#include <filesystem>
#include <optional>
#include <string>

namespace specbake::tool {

/// What the tasks of one farm know together, in a folder beside the results: a file for each
/// texture that failed, named by its result, and the sizes of manifest.h. Each file is written
/// whole, by whoever has to tell something, and none is ever added to: that needs no lock.
class Records {
  public:
    explicit Records(std::filesystem::path folder) : folder_(std::move(folder)) {}

    const std::filesystem::path& folder() const { return folder_; }

    /// Makes the folder. Throws FileError.
    void open() const;

    /// Whether there is the folder.
    bool kept() const;

    /// Keeps a failure, and forgets it when the texture came through. Throws FileError.
    void note(const BatchItem& item, const BatchResult& result) const;

    /// Why the texture could not be baked; nothing if that is not known, or was before the texture
    /// changed.
    std::optional<std::string> failure(const BatchItem& item) const;

  private:
    std::filesystem::path fileOf(const BatchItem& item) const;

    std::filesystem::path folder_;
};

/// The hidden folder for that below which `output` (`-o`) puts all results.
std::filesystem::path recordsFolder(const std::filesystem::path& results);

}  // namespace specbake::tool
