#include "file/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace specbake::internal {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kStart = ".specbake-";
constexpr std::string_view kEnd = ".tmp";

/// The files that are to be removed if the process ends before its time.
struct Registry {
    std::timed_mutex mutex;
    std::set<fs::path> files;
    unsigned counter = 0;
};

/// Never destroyed: a thread may come here while the process ends.
Registry& registry() {
    static auto* all = new Registry;
    return *all;
}

[[noreturn]] void fail() {
    throw std::system_error(errno, std::generic_category());
}

/// How the names of this host's files begin.
std::string prefix() {
    constexpr std::size_t longest = 64;  // of the 255 bytes that names have
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    std::string name = std::string(host.data()).substr(0, longest);
    const auto isPlain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; };
    std::replace_if(
        name.begin(), name.end(), [&](char c) { return !isPlain(static_cast<unsigned char>(c)); },
        '_');
    return std::string(kStart) + name + "-";
}

bool lock(int descriptor, int flags) {
    while (flock(descriptor, LOCK_EX | flags) != 0) {
        if (errno != EINTR) return false;
    }
    return true;
}

/// Removes the file if its process is dead. Where locks are unknown, so is that.
void removeIfDead(const fs::path& path) {
    const int file = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0) return;
    if (lock(file, LOCK_NB)) unlink(path.c_str());
    close(file);
}

/// Once for each folder.
void removeDeadFiles(const fs::path& folder) {
    static auto* const mutex = new std::mutex;
    static auto* const seen = new std::set<fs::path>;
    {
        std::error_code ignored;
        const std::lock_guard guard(*mutex);
        if (!seen->insert(fs::weakly_canonical(folder, ignored)).second) return;
    }
    const std::string ours = prefix();
    std::error_code error;
    for (fs::directory_iterator file(folder, error), end; !error && file != end;
         file.increment(error)) {
        const std::string name = file->path().filename().string();
        if (name.starts_with(ours) && name.ends_with(kEnd)) removeIfDead(file->path());
    }
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& folder, mode_t mode) {
    const fs::path place = folder.empty() ? "." : folder;
    removeDeadFiles(place);
    Registry& all = registry();
    const std::lock_guard guard(all.mutex);
    const std::string start = prefix() + std::to_string(getpid()) + '-';
    do {  // another container may have our number
        path_ = place / (start + std::to_string(all.counter++) + std::string(kEnd));
    } while (!create(mode));
    all.files.insert(path_);
}

/// False if there is such a file, or if it was taken for a dead one before it was locked.
bool TemporaryFile::create(mode_t mode) {
    descriptor_ = open(path_.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, mode);
    if (descriptor_ < 0 && errno == EEXIST) return false;
    if (descriptor_ < 0) fail();
    lock(descriptor_, 0);
    struct stat status {};
    if (fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return true;
    close(descriptor_);
    return false;
}

TemporaryFile::~TemporaryFile() {
    Registry& all = registry();
    const std::lock_guard guard(all.mutex);
    if (all.files.erase(path_) > 0) unlink(path_.c_str());
    close(descriptor_);
}

void TemporaryFile::rename(const fs::path& path) {
    Registry& all = registry();
    const std::lock_guard guard(all.mutex);
    if (::rename(path_.c_str(), path.c_str()) != 0) fail();
    all.files.erase(path_);
}

bool TemporaryFile::isTemporary(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(kStart) && name.ends_with(kEnd);
}

void TemporaryFile::abandonAll() noexcept {
    Registry& all = registry();
    constexpr std::chrono::milliseconds patience(200);  // a thread may hang in a dead disk
    if (!all.mutex.try_lock_for(patience)) return;
    for (const fs::path& file : all.files) unlink(file.c_str());
}

}  // namespace specbake::internal
