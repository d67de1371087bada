#include "support/png_file.h"

#include <libdeflate.h>

#include <memory>

namespace specbake::testing {

std::string bigEndian(std::uint64_t value, int bytes) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += char(value >> shift);
    return text;
}

std::string pngChunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    return bigEndian(data.size(), 4) + body +
           bigEndian(libdeflate_crc32(0, body.data(), body.size()), 4);
}

std::string zlibStream(const std::string& bytes, int level) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    std::string packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                           packed.data(), packed.size()));
    return packed;
}

std::size_t PngFile::rowBytes() const {
    const int channels = (colorType == 2 || colorType == 6 ? 3 : 1) + (colorType >= 4 ? 1 : 0);
    return (std::size_t(width) * std::size_t(channels * bits) + 7) / 8;
}

std::string PngFile::contents() const {
    std::string file = "\x89PNG\r\n\x1a\n";
    file += pngChunk("IHDR", bigEndian(width, 4) + bigEndian(height, 4) + char(bits) +
                                 char(colorType) + '\0' + '\0' + char(interlace));
    file += before;
    std::size_t begin = 0;
    for (const std::size_t end : splits) {
        file += pngChunk("IDAT", packed.substr(begin, end - begin));
        begin = end;
    }
    return file + pngChunk("IDAT", packed.substr(begin)) + after + pngChunk("IEND", "");
}

}  // namespace specbake::testing
