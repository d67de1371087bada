#include "file/write_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace specbake::internal {

WriteStream::WriteStream(const std::filesystem::path& path)
    : file_(open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
    if (file_ < 0) noteError();
}

WriteStream::~WriteStream() {
    if (file_ >= 0) ::close(file_);
}

bool WriteStream::noteError() {
    if (error_ == 0) error_ = errno;
    return false;
}

bool WriteStream::write(const void* bytes, std::size_t count, std::uint64_t offset) {
    const auto* from = static_cast<const std::byte*>(bytes);
    while (count > 0) {
        const ssize_t written = pwrite(file_, from, count, off_t(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return noteError();
        from += written;
        offset += std::uint64_t(written);
        count -= std::size_t(written);
    }
    return true;
}

bool WriteStream::close() {
    const int file = file_;
    file_ = -1;
    return ::close(file) == 0 || noteError();
}

std::string WriteStream::error() const {
    return error_ == 0 ? "" : std::generic_category().message(error_);
}

}  // namespace specbake::internal
