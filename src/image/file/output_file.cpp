#include "file/temporary_file.h"
#include "file/write_stream.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <system_error>

namespace specbake {

using namespace internal;

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, int error) {
    throw FileError(path.string(), std::generic_category().message(error));
}

/// What is under a name, links followed; nothing if there is nothing.
std::optional<struct stat> statusOf(const fs::path& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) return status;
    if (errno != ENOENT) fail(path, errno);
    return {};
}

/// The file behind links.
fs::path target(const fs::path& path) {
    if (!path.has_filename()) fail(path, EISDIR);
    std::error_code ignored;
    const auto status = statusOf(path);
    const bool isLink = fs::is_symlink(fs::symlink_status(path, ignored));
    if (!status) {
        if (isLink) throw FileError(path.string(), "a link to a file that is not there");
        return path;
    }
    if (!S_ISREG(status->st_mode)) throw FileError(path.string(), "not a regular file");
    return isLink ? fs::canonical(path, ignored) : path;
}

/// Nobody reads in the new file what they could not read in the old one.
mode_t firstMode(const fs::path& path) {
    return statusOf(path) ? 0600 : 0666;
}

/// Gives a new file what the old one had. That its owner stays is not to be had by everyone.
void takeOver(int file, const struct stat& old) {
    constexpr mode_t permissions = 0777;
    struct stat now {};
    if (fstat(file, &now) != 0) return;
    const bool sameOwner = now.st_uid == old.st_uid && now.st_gid == old.st_gid;
    const bool owned = sameOwner || fchown(file, old.st_uid, old.st_gid) == 0 ||
                       fchown(file, uid_t(-1), old.st_gid) == 0;
    // Without the group, what the group may do is nobody's.
    static_cast<void>(fchmod(file, old.st_mode & (owned ? permissions : permissions & ~070U)));
}

void syncFolder(const fs::path& folder) {
    const int file =
        open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool synced = file >= 0 && fsync(file) == 0;
    const int error = errno;
    if (file >= 0) close(file);
    if (!synced) fail(folder, error);
}

}  // namespace

OutputFile::OutputFile(const fs::path& path, bool sync) : path_(target(path)), sync_(sync) {
    try {
        temporary_ = std::make_unique<TemporaryFile>(path_.parent_path(), firstMode(path_));
    } catch (const std::system_error& error) {
        fail(path, error.code().value());
    }
}

OutputFile::~OutputFile() = default;

const fs::path& OutputFile::temporaryPath() const {
    return temporary_->path();
}

void OutputFile::commit() {
    const int file = temporary_->descriptor();
    if (const auto old = statusOf(path_)) takeOver(file, *old);
    if (sync_ && fsync(file) != 0) fail(path_, errno);
    try {
        temporary_->rename(path_);
    } catch (const std::system_error& error) {
        fail(path_, error.code().value());
    }
    if (sync_) syncFolder(path_.parent_path());
}

bool OutputFile::isTemporary(const fs::path& path) {
    return TemporaryFile::isTemporary(path);
}

void OutputFile::abandonAll() noexcept {
    TemporaryFile::abandonAll();
}

void writeWhole(const fs::path& path, std::string_view bytes, bool sync) {
    OutputFile file(path, sync);
    WriteStream stream(file.temporaryPath());
    stream.write(bytes.data(), bytes.size(), 0);
    stream.close();
    if (!stream.error().empty()) throw FileError(path.string(), stream.error());
    file.commit();
}

}  // namespace specbake
