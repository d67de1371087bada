#include "file/input_stream.h"

#include <specbake/core/error.h>
#include <specbake/image/file_fingerprint.h>

#include <libdeflate.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace specbake {

std::optional<std::string> fileFingerprint(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return {};
    const internal::InputStream file = internal::openStream(path);
    std::vector<std::byte> buffer(std::size_t(1) << 16);
    std::uint32_t crc = 0;
    std::uint64_t length = 0;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
        crc = libdeflate_crc32(crc, buffer.data(), count);
        length += count;
    }
    if (std::ferror(file.get()) != 0) throw FileError(path, "it cannot be read whole");
    std::array<char, 16> hex{};
    std::snprintf(hex.data(), hex.size(), "%08x", crc);
    return std::to_string(length) + " bytes, CRC-32 " + hex.data();
}

}  // namespace specbake
