#include "target.h"

#include <specbake/core/error.h>
#include <specbake/image/limits.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace specbake::fuzz {

InputFile::InputFile(std::span<const std::uint8_t> bytes)
    : file_(memfd_create("fuzz", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(file_)) {
    if (file_ < 0 || write(file_, bytes.data(), bytes.size()) != ssize_t(bytes.size())) {
        throw std::runtime_error("no file in memory");
    }
}

InputFile::~InputFile() {
    close(file_);
}

void expect(bool holds) {
    if (!holds) std::abort();
}

}  // namespace specbake::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace specbake;
    // A limit of memory that is far below the fuzzer's own, so that it shows what goes beyond.
    setLimits({std::uint64_t(1) << 20, std::uint64_t(1) << 28});
    try {
        fuzz::run({data, size});
    } catch (const FileError& error) {
        fuzz::expect(std::string_view(error.what()).find('\n') == std::string_view::npos);
    } catch (const Error&) {  // of a text that is told again as it was
    }
    return 0;
}
