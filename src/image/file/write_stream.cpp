#include "file/write_stream.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <system_error>

namespace specbake::internal {
namespace {

constexpr std::uint64_t kPage = 4096;
/// Less than that is gathered.
constexpr std::size_t kSmall = 1 << 16;
/// Space is taken in steps as large as what is written, between these.
constexpr std::uint64_t kLeastStep = 1 << 20;
constexpr std::uint64_t kLargestStep = 1 << 24;

/// Space from `begin` to `end` of a file whose size stays. False, with errno, if it is not to be
/// had.
bool take(int file, std::uint64_t begin, std::uint64_t end) {
#ifdef __linux__
    return fallocate(file, FALLOC_FL_KEEP_SIZE, off_t(begin), off_t(end - begin)) == 0;
#else
    static_cast<void>(file);
    errno = EOPNOTSUPP;
    return begin == end;
#endif
}

}  // namespace

std::uint64_t largestFile() {
    rlimit limit{};
    if (getrlimit(RLIMIT_FSIZE, &limit) != 0) return 0;
    constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
    return limit.rlim_cur == RLIM_INFINITY ? all : std::uint64_t(limit.rlim_cur);
}

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

// Beyond the limit some systems send a signal that ends the program: no space is taken there.
bool WriteStream::reserve(std::uint64_t size) {
    takes_ = takes_ && size <= largestFile();
    if (!takes_ || size <= taken_) return true;
    takes_ = take(file_, taken_, size);
    if (takes_) taken_ = size;
    const bool tooLarge = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
    return takes_ || !tooLarge || noteError();
}

void WriteStream::takeAhead(std::uint64_t end) {
    if (!takes_ || end < kLeastStep || end <= taken_) return;
    const std::uint64_t ahead = end + std::min(end, kLargestStep);
    takes_ = ahead <= largestFile() && take(file_, taken_, ahead);
    if (takes_) taken_ = ahead;
}

bool WriteStream::write(const void* bytes, std::size_t count, std::uint64_t offset) {
    const auto* from = static_cast<const std::byte*>(bytes);
    if (offset != next_ + waiting_.size()) {
        if (!flush()) return false;
        next_ = offset;
    }
    if (waiting_.size() + count < kSmall) {
        waiting_.insert(waiting_.end(), from, from + count);
        return error_ == 0;
    }
    const std::uint64_t end = offset + count;
    const std::uint64_t behind = end % kPage;  // fewer than these bytes, which are at least kSmall
    const std::size_t now = count - std::min(count, std::size_t(behind));
    if (!writeOut(from, now)) return false;
    waiting_.assign(from + now, from + count);
    return true;
}

bool WriteStream::writeOut(const std::byte* bytes, std::size_t count) {
    takeAhead(next_ + waiting_.size() + count);
    const std::byte* waiting = waiting_.data();
    std::size_t left = waiting_.size();
    while (left + count > 0) {
        // iovec has no constant pointers; nothing is written through these.
        const std::array<iovec, 2> parts = {
            {{const_cast<std::byte*>(waiting), left}, {const_cast<std::byte*>(bytes), count}}};
        const ssize_t written = pwritev(file_, parts.data(), int(parts.size()), off_t(next_));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return noteError();
        const std::size_t ofWaiting = std::min(left, std::size_t(written));
        const std::size_t ofBytes = std::size_t(written) - ofWaiting;
        waiting += ofWaiting;
        left -= ofWaiting;
        bytes += ofBytes;
        count -= ofBytes;
        next_ += std::uint64_t(written);
        size_ = std::max(size_, next_);
    }
    waiting_.clear();
    return true;
}

bool WriteStream::flush() {
    return writeOut(nullptr, 0);
}

bool WriteStream::close() {
    if (error_ == 0) flush();
    if (error_ == 0 && taken_ > size_ && ftruncate(file_, off_t(size_)) != 0) noteError();
    const int file = file_;
    file_ = -1;
    return ::close(file) == 0 ? error_ == 0 : noteError();
}

std::string WriteStream::error() const {
    return error_ == 0 ? "" : std::generic_category().message(error_);
}

}  // namespace specbake::internal
