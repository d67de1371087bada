#pragma once

#include <specbake/core/api.h>

#include <filesystem>
#include <memory>
#include <string_view>

namespace specbake {

namespace internal {
class TemporaryFile;
}

/// A file that appears whole or not at all: it is written under a temporary name in the same
/// folder and renamed by commit(); without commit() the temporary file is removed. What was under
/// the name before is replaced, and gives the new file its permissions, and its owner where that
/// may be.
class SPECBAKE_API OutputFile {
  public:
    /// Creates the temporary file. A link is followed. `sync`: commit() waits until the disk has
    /// the file, so that it outlives a power cut. Throws FileError if the folder cannot be written,
    /// or if `path` names something else than a regular file, or is a link to nothing.
    explicit OutputFile(const std::filesystem::path& path, bool sync = false);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// To be opened without being created or locked.
    const std::filesystem::path& temporaryPath() const;

    /// Replaces `path()` by what was written. Throws FileError.
    void commit();

    /// Whether a name is that of a temporary file, of whatever host and process.
    static bool isTemporary(const std::filesystem::path& path);

    /// For a process that is about to end by a signal: removes the temporary files of all that
    /// there are. Whoever makes or commits one after that waits until the process has ended.
    static void abandonAll() noexcept;

  private:
    std::filesystem::path path_;
    bool sync_;
    std::unique_ptr<internal::TemporaryFile> temporary_;
};

/// Writes a whole file by an OutputFile. Throws FileError.
SPECBAKE_API void writeWhole(const std::filesystem::path& path, std::string_view bytes,
                             bool sync = false);

}  // namespace specbake
