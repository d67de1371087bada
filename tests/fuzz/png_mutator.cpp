#include <libdeflate.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

// libFuzzer's own (fuzzer interface of LLVM).
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

std::uint32_t bigEndian(const std::uint8_t* at) {
    return std::uint32_t(at[0]) << 24 | std::uint32_t(at[1]) << 16 | std::uint32_t(at[2]) << 8 |
           std::uint32_t(at[3]);
}

/// Else almost every mutation ends at a chunk's checksum.
void repairChecksums(std::uint8_t* data, std::size_t size) {
    constexpr std::size_t signature = 8;
    constexpr std::size_t frame = 12;  // length, type, checksum
    for (std::size_t at = signature; at + frame <= size;) {
        const std::size_t length = bigEndian(data + at);
        if (length > size - at - frame) return;
        const std::uint32_t crc = libdeflate_crc32(0, data + at + 4, length + 4);
        for (int i = 0; i < 4; ++i) {
            data[at + 8 + length + std::size_t(i)] = std::uint8_t(crc >> (24 - 8 * i));
        }
        at += frame + length;
    }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
    const std::size_t newSize = LLVMFuzzerMutate(data, size, maxSize);
    const bool isPng = newSize > 8 && std::memcmp(data, "\x89PNG", 4) == 0;
    if (isPng && seed % 8 != 0) repairChecksums(data, newSize);
    return newSize;
}
