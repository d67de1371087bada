#pragma once

#include <sys/stat.h>

#include <filesystem>

namespace specbake::internal {

/// A hidden file that waits to take another's name. It is locked as long as this object lives, so
/// that whoever finds it unlocked knows that its process is dead: the first file of a process in a
/// folder removes such remains of processes of this host.
class TemporaryFile {
  public:
    /// `folder`: empty for the current one. Throws std::system_error.
    TemporaryFile(const std::filesystem::path& folder, mode_t mode);
    /// Removes the file, unless it has another name by now.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    int descriptor() const { return descriptor_; }

    /// Throws std::system_error.
    void rename(const std::filesystem::path& path);

    /// Of whatever host and process.
    static bool isTemporary(const std::filesystem::path& path);

    /// Removes all that there are. Who makes one after that, or renames one, waits for ever.
    static void abandonAll() noexcept;

  private:
    bool create(mode_t mode);

    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace specbake::internal
