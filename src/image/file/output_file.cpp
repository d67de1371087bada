#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace specbake {
namespace fs = std::filesystem;
namespace {

fs::path target(const fs::path& path) {
    std::error_code ignored;
    fs::path resolved = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path) : path;
    const auto status = fs::status(resolved, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw FileError(path.string(), "not a regular file");
    }
    return resolved;
}

/// Unique among processes and within this one; hidden, and beside the target.
fs::path temporaryName(const fs::path& path) {
    static std::atomic<unsigned> counter = 0;
    fs::path name(".");
    name += path.filename();
    name += '.' + std::to_string(getpid()) + '-' + std::to_string(counter++) + ".tmp";
    return path.parent_path() / name;
}

}  // namespace

OutputFile::OutputFile(const fs::path& path)
    : path_(target(path)), temporary_(temporaryName(path_)) {
    const int file = open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file < 0) throw FileError(path.string(), std::strerror(errno));
    close(file);
}

OutputFile::~OutputFile() {
    std::error_code ignored;
    if (!committed_) fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) throw FileError(path_.string(), error.message());
    committed_ = true;
}

}  // namespace specbake
