#include "texture/color/png_signs.h"

#include <libdeflate.h>

#include <cstdint>
#include <memory>

namespace specbake::internal {
namespace {

std::uint32_t bigEndian(std::string_view data, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(data[at + i]);
    return value;
}

/// PNG's fixed-point numbers.
double hundredThousandths(std::string_view data, std::size_t index) {
    return double(bigEndian(data, 4 * index)) / 1e5;
}

/// Empty if it is damaged or too large.
std::string inflated(std::string_view packed) {
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
        inflater(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (!inflater) return {};
    for (std::size_t size = 1 << 14; size <= kLargestProfile; size *= 4) {
        std::string bytes(size, '\0');
        std::size_t written = 0;
        const libdeflate_result result = libdeflate_zlib_decompress(
            inflater.get(), packed.data(), packed.size(), bytes.data(), size, &written);
        if (result == LIBDEFLATE_SUCCESS) {
            bytes.resize(written);
            return bytes;
        }
        if (result != LIBDEFLATE_INSUFFICIENT_SPACE) return {};
    }
    return {};
}

/// A name of up to 79 letters, a zero, the method 0, and a zlib stream.
bool readProfile(std::string_view data, ColorSigns& signs) {
    const std::size_t end = data.substr(0, 80).find('\0');
    if (end == std::string_view::npos || data.size() < end + 2 || data[end + 1] != 0) return false;
    signs.icc = inflated(data.substr(end + 2));
    return !signs.icc.empty();
}

bool readCodePoints(std::string_view data, ColorSigns& signs) {
    if (data.size() != 4) return false;
    const auto at = [&](std::size_t i) { return int(std::uint8_t(data[i])); };
    signs.cicp = CodePoints{at(0), at(1), at(2), at(3) != 0};
    return true;
}

bool readChromaticities(std::string_view data, ColorSigns& signs) {
    if (data.size() != 32) return false;
    const auto at = [&](std::size_t i) {
        return Chromaticity{hundredThousandths(data, i), hundredThousandths(data, i + 1)};
    };
    signs.chromaticities = Primaries{at(2), at(4), at(6), at(0)};  // the white comes first
    return true;
}

bool readGamma(std::string_view data, ColorSigns& signs) {
    if (data.size() != 4 || bigEndian(data, 0) == 0) return false;
    signs.gamma = hundredThousandths(data, 0);
    return true;
}

}  // namespace

void readPngColorChunk(std::string_view name, std::string_view data, ColorSigns& signs,
                       std::vector<std::string>& notes) {
    bool good = true;
    if (name == "iCCP") good = readProfile(data, signs);
    if (name == "cICP") good = readCodePoints(data, signs);
    if (name == "cHRM") good = readChromaticities(data, signs);
    if (name == "gAMA") good = readGamma(data, signs);
    if (name == "sRGB") signs.srgb = good = data.size() == 1;
    if (!good) notes.push_back("its " + std::string(name) + " chunk is damaged, and not used");
}

}  // namespace specbake::internal
