#pragma once

#include "support/contents.h"

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace specbake::testing {

/// A folder of its own for each test, removed at the end.
class Scratch {
  public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    /// The names of the files in it, hidden ones too, in order.
    std::vector<std::string> names() const;

  private:
    std::filesystem::path folder_;
};

/// How a process ended, and what it said.
struct Outcome {
    int exitCode = -1;  ///< -1: it ended by a signal
    int signal = 0;
    std::string out;
    std::string err;
};

/// The program under test, running.
class Process {
  public:
    explicit Process(std::vector<std::string> arguments);
    /// Started by a shell behind these commands, such as "ulimit -f 8", and with these
    /// redirections.
    Process(const std::string& shell, std::vector<std::string> arguments,
            const std::string& redirections = "");
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    pid_t id() const { return id_; }
    bool isRunning();
    void send(int signal) const;
    Outcome wait();

  private:
    void start(std::vector<std::string> arguments);

    Scratch output_;
    pid_t id_ = -1;
    int status_ = 0;
    bool ended_ = false;
};

/// Runs `specbake` with these arguments to its end.
Outcome runTool(std::vector<std::string> arguments);

Outcome runIn(const std::string& shell, std::vector<std::string> arguments,
              const std::string& redirections = "");

/// A file of testimages/.
std::string testImage(const std::string& name);

/// The images of testimages/, by name.
std::vector<std::string> testImages();

void writeFile(const std::string& path, const std::string& contents);
std::vector<std::string> linesOf(const std::string& text);

}  // namespace specbake::testing
