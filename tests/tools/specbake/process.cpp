#include "process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace specbake::testing {

namespace fs = std::filesystem;

Scratch::Scratch() {
    std::string name = (fs::temp_directory_path() / "specbake-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
    folder_ = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

std::vector<std::string> Scratch::names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Process::Process(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), SPECBAKE_PROGRAM);
    start(std::move(arguments));
}

Process::Process(const std::string& shell, std::vector<std::string> arguments,
                 const std::string& redirections) {
    const std::string commands = shell + (shell.empty() ? "" : "; ") + "exec \"$@\" ";
    arguments.insert(arguments.begin(),
                     {"/bin/sh", "-c", commands + redirections, "sh", SPECBAKE_PROGRAM});
    start(std::move(arguments));
}

void Process::start(std::vector<std::string> arguments) {
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    const int create = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, output_.path("out").c_str(), create, 0600);
    posix_spawn_file_actions_addopen(&files, 2, output_.path("err").c_str(), create, 0600);
    const int error = posix_spawn(&id_, argv.front(), &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw std::runtime_error(arguments.front() + ": cannot be started");
}

Process::~Process() {
    if (ended_) return;
    send(SIGKILL);
    waitpid(id_, &status_, 0);
}

bool Process::isRunning() {
    if (!ended_) ended_ = waitpid(id_, &status_, WNOHANG) == id_;
    return !ended_;
}

void Process::send(int signal) const {
    kill(id_, signal);
}

Outcome Process::wait() {
    if (!ended_) waitpid(id_, &status_, 0);
    ended_ = true;
    Outcome outcome;
    if (WIFEXITED(status_)) outcome.exitCode = WEXITSTATUS(status_);
    if (WIFSIGNALED(status_)) outcome.signal = WTERMSIG(status_);
    outcome.out = contentsOf(output_.path("out"));
    outcome.err = contentsOf(output_.path("err"));
    return outcome;
}

Outcome runTool(std::vector<std::string> arguments) {
    return Process(std::move(arguments)).wait();
}

Outcome runIn(const std::string& shell, std::vector<std::string> arguments,
              const std::string& redirections) {
    return Process(shell, std::move(arguments), redirections).wait();
}

std::string testImage(const std::string& name) {
    return std::string(SPECBAKE_SOURCE_DIR) + "/testimages/" + name;
}

std::vector<std::string> testImages() {
    const std::set<std::string> kinds = {".png", ".jpg", ".tif", ".exr", ".hdr", ".tga", ".bmp"};
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(testImage(""))) {
        if (kinds.count(entry.path().extension().string()) > 0) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    if (names.empty()) throw std::runtime_error("no test images");
    return names;
}

void writeFile(const std::string& path, const std::string& contents) {
    std::ofstream out(path, std::ios::binary);
    out << contents;
    out.close();
    if (!out) throw std::runtime_error(path + ": cannot be written");
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

}  // namespace specbake::testing
