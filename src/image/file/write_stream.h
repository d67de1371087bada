#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace specbake::internal {

/// Writes into a file that exists and is empty. It is not truncated once more: ext4 would take that
/// for a file being replaced, and wait at its end until the disk has made room for all of it.
class WriteStream {
  public:
    /// A file that cannot be opened is an error(), like one that cannot be written.
    explicit WriteStream(const std::filesystem::path& path);
    ~WriteStream();
    WriteStream(const WriteStream&) = delete;
    WriteStream& operator=(const WriteStream&) = delete;

    /// False if not all of it could be written.
    bool write(const void* bytes, std::size_t count, std::uint64_t offset);

    /// Once, when all is written; false if the system says only now that it could not.
    bool close();

    /// The system's word on what went wrong first; empty if nothing did.
    std::string error() const;

  private:
    bool noteError();

    int file_ = -1;
    int error_ = 0;
};

}  // namespace specbake::internal
