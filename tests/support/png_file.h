#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace specbake::testing {

/// A PNG put together by hand, so that it may be odd or wrong.
struct PngFile {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    int bits = 8;
    int colorType = 2;  ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    int interlace = 0;
    std::string before;               ///< whole chunks between IHDR and the pixels
    std::string packed;               ///< the zlib stream
    std::vector<std::size_t> splits;  ///< where the stream goes on in another IDAT chunk, in order
    std::string after;                ///< whole chunks between the pixels and IEND

    std::size_t rowBytes() const;
    std::string contents() const;
};

/// A chunk with its length and checksum.
std::string pngChunk(const std::string& type, const std::string& data);

/// The least significant byte last.
std::string bigEndian(std::uint64_t value, int bytes);

/// A zlib stream; `level` is libdeflate's, 1 to 12.
std::string zlibStream(const std::string& bytes, int level = 6);

}  // namespace specbake::testing
