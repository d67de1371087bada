#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

namespace specbake::internal {

/// What a process is asked for (serveIsolatedReads()).
enum class Request : int { open, text, rows };

/// How it answers.
enum class Answer : int { done, failed };

/// A process that reads images for this one, and the socket to it.
class ReaderProcess {
  public:
    /// Throws std::system_error.
    explicit ReaderProcess(const std::vector<std::string>& program);
    /// Ends the process if it has not ended.
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    int socket() const { return socket_; }

    /// Why it does not answer any more: "its reader crashed (SIGSEGV)". Ends it.
    std::string death();

  private:
    int socket_ = -1;
    pid_t id_ = -1;
};

/// One that waits for work, or a new one. Throws std::system_error.
std::unique_ptr<ReaderProcess> idleReader(const std::vector<std::string>& program);

/// Keeps it for the next file: to start one takes as long as to read a small image.
void keepIdle(std::unique_ptr<ReaderProcess> reader);

}  // namespace specbake::internal
