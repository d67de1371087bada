#include "png_check.h"

#include <specbake/core/error.h>
#include <specbake/image/image_types.h>

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

    /// Reads a chunk and gives its type.
    std::string next() {
        const std::uint32_t length = number();
        std::string type(4, '\0');
        read(type.data(), type.size());
        if (!std::all_of(type.begin(), type.end(), isLetter)) fail("damaged: a chunk of no type");
        std::uint32_t sum = libdeflate_crc32(0, type.data(), type.size());
        for (std::size_t left = length; left > 0;) {
            const std::size_t part = std::min(left, buffer_.size());
            read(buffer_.data(), part);
            sum = libdeflate_crc32(sum, buffer_.data(), part);
            left -= part;
        }
        if (number() != sum) fail("damaged: wrong checksum of its " + type + " chunk");
        return type;
    }

    /// The number at an offset of the data of the chunk that was read, a short one.
    std::uint32_t field(std::size_t offset) const { return bigEndian(buffer_.data() + offset); }

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
        return bigEndian(bytes.data());
    }

    static std::uint32_t bigEndian(const char* bytes) {
        std::uint32_t value = 0;
        for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
        return value;
    }

    std::string path_;
    std::ifstream in_;
    std::vector<char> buffer_ = std::vector<char>(1 << 16);
};

}  // namespace

void checkPng(const std::string& path) {
    Chunks chunks(path);
    if (!chunks.isPng()) return;
    if (chunks.next() != "IHDR") chunks.fail("damaged: it does not begin with its header");
    for (const std::uint32_t side : {chunks.field(0), chunks.field(4)}) {
        if (side == 0) chunks.fail("it has no pixels");
        if (side > std::uint32_t(kLargestSide)) {
            chunks.fail("a side of more than " + std::to_string(kLargestSide) + " pixels");
        }
    }
    while (chunks.next() != "IEND") {
    }
}

}  // namespace specbake
