#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// Each target is a function of this name in a program of its own: it may throw what the library
/// says that it throws, and nothing else (target.cpp has the loop's entry).
namespace specbake::fuzz {

void run(std::span<const std::uint8_t> bytes);

/// Bytes as a file that readers can open by its name, as long as this object lives.
class InputFile {
  public:
    explicit InputFile(std::span<const std::uint8_t> bytes);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    int file_;
    std::string path_;
};

/// Ends the process, so that the fuzzer takes it for a finding.
void expect(bool holds);

inline std::string_view textOf(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace specbake::fuzz
