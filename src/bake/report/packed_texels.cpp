#include "report/packed_texels.h"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <new>
#include <span>

namespace specbake::internal {
namespace {

using Bytes = std::vector<std::uint8_t>;

void setInterval(const std::vector<float>& bands, PackedTexels& packed) {
    for (const float value : bands) {
        if (!std::isfinite(value)) continue;
        packed.low = std::min(packed.low, double(value));
        packed.high = std::max(packed.high, double(value));
    }
}

unsigned codeOf(float value, const PackedTexels& interval) {
    if (!std::isfinite(value)) return 0;
    const double share = (double(value) - interval.low) / (interval.high - interval.low);
    return unsigned(std::lround(65535 * share));
}

/// A difference of codes modulo 65536, small ones of either sign small.
unsigned folded(unsigned code, unsigned before) {
    const auto difference = std::int16_t(std::uint16_t(code - before));
    return std::uint16_t((difference * 2) ^ (difference < 0 ? -1 : 0));
}

void addBands(const SampledTexels& texels, const PackedTexels& interval, Bytes& bytes) {
    const std::size_t count = texels.blocks.count();
    std::vector<unsigned> before(count);
    for (std::size_t band = 0; band < texels.bandCount; ++band) {
        const std::size_t first = bytes.size();
        bytes.resize(first + 2 * count);
        for (std::size_t t = 0; t < count; ++t) {
            const unsigned code = codeOf(texels.bands[t * texels.bandCount + band], interval);
            const unsigned difference = folded(code, before[t]);
            bytes[first + t] = std::uint8_t(difference >> 8);
            bytes[first + count + t] = std::uint8_t(difference & 255);
            before[t] = code;
        }
    }
}

void addDifferences(const std::vector<float>& differences, Bytes& bytes) {
    for (const float value : differences) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (const int shift : {0, 8, 16, 24}) bytes.push_back(std::uint8_t(bits >> shift));
    }
}

Bytes zlibbed(const Bytes& bytes) {
    constexpr int level = 9;
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    Bytes packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                           packed.data(), packed.size()));
    return packed;
}

/// RFC 4648, section 4.
std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < here ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= here ? digits[bits >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

}  // namespace

PackedTexels packTexels(const SampledTexels& texels) {
    PackedTexels packed;
    setInterval(texels.bands, packed);
    Bytes bytes;
    addBands(texels, packed, bytes);
    addDifferences(texels.differences, bytes);
    bytes.insert(bytes.end(), texels.marks.begin(), texels.marks.end());
    packed.text = base64(zlibbed(bytes));
    return packed;
}

}  // namespace specbake::internal
