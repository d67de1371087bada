#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace specbake::internal {

/// What the system lets a file grow to (RLIMIT_FSIZE); 0 if it does not say.
std::uint64_t largestFile();

/// Writes into a file that exists and is empty. It is not truncated once more: ext4 would take that
/// for a file being replaced, and wait at its end until the disk has made room for all of it.
///
/// What follows each other goes to the system in whole pages, and into space that was taken before:
/// ext4 copies it in half the time.
class WriteStream {
  public:
    /// A file that cannot be opened is an error(), like one that cannot be written.
    explicit WriteStream(const std::filesystem::path& path);
    ~WriteStream();
    WriteStream(const WriteStream&) = delete;
    WriteStream& operator=(const WriteStream&) = delete;

    /// Takes space for that many bytes. False if there is not so much; where the system cannot say,
    /// or cannot take it, it is taken while writing.
    bool reserve(std::uint64_t size);

    /// False if something could not be written, now or before. What is less than a page may wait
    /// for what follows.
    bool write(const void* bytes, std::size_t count, std::uint64_t offset);

    /// Once, when all is written; false if not all of it could be.
    bool close();

    /// The system's word on what went wrong first; empty if nothing did.
    std::string error() const;

  private:
    bool noteError();
    /// The bytes that wait, and then these.
    bool writeOut(const std::byte* bytes, std::size_t count);
    bool flush();
    void takeAhead(std::uint64_t end);

    int file_ = -1;
    int error_ = 0;
    std::vector<std::byte> waiting_;  ///< for offset next_
    std::uint64_t next_ = 0;
    std::uint64_t size_ = 0;   ///< of the file
    std::uint64_t taken_ = 0;  ///< space for so many bytes is the file's
    bool takes_ = true;        ///< until the system cannot
};

}  // namespace specbake::internal
