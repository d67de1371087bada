#pragma once

#include <specbake/core/api.h>

#include <filesystem>

namespace specbake {

/// A file that appears whole or not at all: it is written under a temporary name in the same
/// folder and renamed by commit(); without commit() the temporary file is removed.
class SPECBAKE_API OutputFile {
  public:
    /// Creates the temporary file. A link is followed. Throws FileError if the folder cannot be
    /// written, or if `path` names something else than a regular file.
    explicit OutputFile(const std::filesystem::path& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& temporaryPath() const { return temporary_; }

    /// Replaces `path()` by what was written. Throws FileError.
    void commit();

  private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

}  // namespace specbake
