#include "png_chunks.h"

#include <specbake/core/error.h>

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

namespace specbake {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n"sv;

constexpr std::array<char, 4> kHeader = {'I', 'H', 'D', 'R'};
constexpr std::array<char, 4> kEnd = {'I', 'E', 'N', 'D'};

/// The chunks of a PNG, one after the other (PNG specification, 5.3): length, type, data, checksum
/// of type and data.
class Chunks {
  public:
    explicit Chunks(const std::string& path) : path_(path), in_(path, std::ios::binary) {}

    bool isPng() {
        std::string first(kSignature.size(), '\0');
        in_.read(first.data(), std::streamsize(first.size()));
        return in_ && first == kSignature;
    }

    /// Passes over a chunk.
    PngChunk next() {
        const std::uint32_t length = number();
        std::array<char, 4> type{};
        read(type.data(), type.size());
        const auto offset = std::uint64_t(in_.tellg());
        if (!std::all_of(type.begin(), type.end(), isLetter)) fail("damaged: a chunk of no type");
        std::uint32_t sum = libdeflate_crc32(0, type.data(), type.size());
        for (std::size_t left = length; left > 0;) {
            const std::size_t part = std::min(left, buffer_.size());
            read(buffer_.data(), part);
            sum = libdeflate_crc32(sum, buffer_.data(), part);
            left -= part;
        }
        if (number() != sum) {
            fail("damaged: wrong checksum of its " + std::string(type.data(), type.size()) +
                 " chunk");
        }
        return {type, length, offset};
    }

    [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, reason); }

  private:
    static bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

    void read(char* to, std::size_t count) {
        in_.read(to, std::streamsize(count));
        if (!in_) fail("truncated");
    }

    std::uint32_t number() {
        std::array<char, 4> bytes{};
        read(bytes.data(), bytes.size());
        std::uint32_t value = 0;
        for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
        return value;
    }

    std::string path_;
    std::ifstream in_;
    std::vector<char> buffer_ = std::vector<char>(1 << 16);
};

}  // namespace

std::vector<PngChunk> pngChunks(const std::string& path) {
    Chunks chunks(path);
    if (!chunks.isPng()) return {};
    std::vector<PngChunk> list = {chunks.next()};
    if (list[0].type != kHeader) chunks.fail("damaged: it does not begin with its header");
    while (list.back().type != kEnd) list.push_back(chunks.next());
    return list;
}

}  // namespace specbake
