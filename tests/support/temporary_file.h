#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace specbake::testing {

/// A file that is there as long as this object; one at a time for each extension.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& contents, const std::string& extension = ".png")
        : path_(std::filesystem::temp_directory_path() /
                ("specbake_test." + std::to_string(getpid()) + extension)) {
        std::ofstream(path_, std::ios::binary) << contents;
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

}  // namespace specbake::testing
