#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace specbake {

/// Where the data of one chunk of a PNG is.
struct PngChunk {
    std::array<char, 4> type;
    std::uint32_t length;
    std::uint64_t offset;  ///< in the file, bytes
};

/// The chunks of a PNG from IHDR to IEND; none for a file that does not begin as a PNG. Throws
/// FileError if the file begins as one and is not whole: chunks that end early or do not have their
/// checksum, or no end. libpng says so on stderr besides, and not where all pixels are there.
std::vector<PngChunk> pngChunks(const std::string& path);

}  // namespace specbake
