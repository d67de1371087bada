#include "texture/isolate/reader_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <system_error>
#include <utility>

namespace specbake::internal {
namespace {

void check(int error) {
    if (error != 0) throw std::system_error(error, std::generic_category());
}

/// The socket becomes standard input; nothing that its libraries print is for the user.
pid_t spawn(const std::vector<std::string>& program, int socket) {
    std::vector<std::string> words = program;
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, socket, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    pid_t id = -1;
    const int error = posix_spawn(&id, argv.front(), &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    check(error);
    return id;
}

/// Those without work, ended with the program.
struct Idle {
    std::mutex mutex;
    std::vector<std::unique_ptr<ReaderProcess>> readers;
};

Idle& idle() {
    static Idle all;
    return all;
}

}  // namespace

ReaderProcess::ReaderProcess(const std::vector<std::string>& program) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) check(errno);
    socket_ = ends[0];
    try {
        id_ = spawn(program, ends[1]);
    } catch (...) {
        close(ends[0]);
        close(ends[1]);
        throw;
    }
    close(ends[1]);
}

ReaderProcess::~ReaderProcess() {
    close(socket_);
    if (id_ < 0) return;
    kill(id_, SIGKILL);
    while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::string ReaderProcess::death() {
    constexpr const char* unknown = "its reader ended without a word";
    shutdown(socket_, SHUT_RDWR);
    int status = 0;
    pid_t ended = 0;
    do {
        ended = waitpid(id_, &status, 0);
    } while (ended < 0 && errno == EINTR);
    id_ = -1;
    if (ended < 0 || !WIFSIGNALED(status)) return unknown;
    const char* name = sigabbrev_np(WTERMSIG(status));
    return std::string("its reader crashed (SIG") + (name == nullptr ? "?" : name) + ")";
}

std::unique_ptr<ReaderProcess> idleReader(const std::vector<std::string>& program) {
    Idle& all = idle();
    const std::lock_guard guard(all.mutex);
    if (all.readers.empty()) return std::make_unique<ReaderProcess>(program);
    auto reader = std::move(all.readers.back());
    all.readers.pop_back();
    return reader;
}

void keepIdle(std::unique_ptr<ReaderProcess> reader) {
    Idle& all = idle();
    const std::lock_guard guard(all.mutex);
    all.readers.push_back(std::move(reader));
}

}  // namespace specbake::internal
