#include "texture/openimageio/output/checked_output.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <vector>

namespace specbake::internal {

std::size_t CheckedOutput::Proxy::write(const void* bytes, std::size_t count) {
    const std::size_t written = pwrite(bytes, count, m_pos);
    m_pos += std::int64_t(written);
    return written;
}

std::size_t CheckedOutput::Proxy::pwrite(const void* bytes, std::size_t count,
                                         std::int64_t offset) {
    if (!stream_.write(bytes, count, std::uint64_t(offset))) return 0;
    size_ = std::max(size_, std::size_t(offset) + count);
    empty_ = empty_ && count == 0;
    return count;
}

CheckedOutput::CheckedOutput(const std::filesystem::path& file) : stream_(file) {}

CheckedOutput::~CheckedOutput() {
    if (memory_ >= 0) ::close(memory_);
}

bool CheckedOutput::open(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec) {
    if (output.supports("ioproxy") != 0) {
        return output.set_ioproxy(&proxy_) && output.open("picture", spec);
    }
    memory_ = memfd_create("picture", MFD_CLOEXEC);
    return output.open("/proc/self/fd/" + std::to_string(memory_), spec);
}

/// A file in memory ends where the limit on files' sizes cuts it, and its format does not notice.
bool CheckedOutput::isCut() const {
    struct stat status {};
    return fstat(memory_, &status) != 0 || std::uint64_t(status.st_size) >= largestFile();
}

bool CheckedOutput::copyMemory() {
    if (isCut()) return false;
    std::vector<std::byte> bytes(std::size_t(1) << 20);
    std::uint64_t offset = 0;
    while (true) {
        const ssize_t count = pread(memory_, bytes.data(), bytes.size(), off_t(offset));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        if (count == 0) return true;
        if (!stream_.write(bytes.data(), std::size_t(count), offset)) return false;
        offset += std::uint64_t(count);
        empty_ = false;
    }
}

bool CheckedOutput::close() {
    const bool copied = memory_ < 0 || copyMemory();
    return stream_.close() && copied && !empty_ && stream_.error().empty();
}

}  // namespace specbake::internal
