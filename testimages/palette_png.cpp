#include "palette_png.h"

#include <libdeflate.h>

#include <cstdint>
#include <fstream>
#include <stdexcept>

namespace testimages {
namespace {

std::string bigEndian(std::uint32_t v) {
    return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)};
}

/// Length, type, data, checksum of type and data (PNG specification, 5.3).
std::string chunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    return bigEndian(std::uint32_t(data.size())) + body +
           bigEndian(libdeflate_crc32(0, body.data(), body.size()));
}

/// zlib (RFC 1950) with one stored block (RFC 1951, 3.2.4).
std::string stored(const std::string& data) {
    const auto n = std::uint16_t(data.size());
    const auto inverse = std::uint16_t(~n);
    const std::string length = {char(n), char(n >> 8), char(inverse), char(inverse >> 8)};
    return "\x78\x01\x01" + length + data +
           bigEndian(libdeflate_adler32(1, data.data(), data.size()));
}

}  // namespace

void writePalettePng(const std::string& path) {
    constexpr char side = 8;
    constexpr int colors = 16;
    std::string palette;
    for (int i = 0; i < colors; ++i) {
        palette += char(17 * i);
        palette += char(255 - 17 * i);
        palette += char(17 * ((5 * i) % 16));
    }
    std::string rows;
    for (int y = 0; y < side; ++y) {
        rows += '\0';  // no filter
        for (int x = 0; x < side; ++x) rows += char((3 * x + y) % colors);
    }
    const std::string header = bigEndian(side) + bigEndian(side) + std::string("\x08\x03\0\0\0", 5);
    std::ofstream out(path, std::ios::binary);
    out << "\x89PNG\r\n\x1a\n"
        << chunk("IHDR", header) << chunk("PLTE", palette) << chunk("IDAT", stored(rows))
        << chunk("IEND", "");
    out.close();
    if (!out) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace testimages
