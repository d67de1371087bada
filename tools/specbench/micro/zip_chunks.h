#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace specbake::bench {

/// What zip's encoder was given for one chunk of a file: the samples' bytes, reordered and
/// predicted.
struct ZipChunk {
    std::vector<std::uint8_t> bytes;
    std::size_t rowLength;  ///< bytes after which a row of the next channel begins
};

/// At most `most` chunks of a ZIP file of scan lines whose channels have one type, spread evenly
/// over it. Read with OpenEXRCore and inflated with libdeflate. Throws std::runtime_error.
std::vector<ZipChunk> readZipChunks(const std::string& file, std::size_t most);

}  // namespace specbake::bench
