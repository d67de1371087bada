#include "texture/plain/exr_attributes.h"

#include <specbake/core/error.h>
#include <specbake/image/limits.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace specbake::internal {
namespace {

struct FixedType {
    std::string_view name;
    std::uint64_t size;
};

/// OpenEXR, "File Layout": the types whose values always take the same number of bytes.
constexpr std::array<FixedType, 24> kFixedTypes = {{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

/// The headers from the first byte on. What is read beyond the end is 0, and ends the walk.
class Headers {
  public:
    explicit Headers(const std::string& path) : file_(path, std::ios::binary) {
        std::error_code error;
        size_ = std::filesystem::file_size(path, error);
        if (error) file_.setstate(std::ios::failbit);
    }

    explicit operator bool() const { return bool(file_); }

    std::uint32_t number() {
        std::array<unsigned char, 4> bytes{};
        file_.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
        return bytes[0] | std::uint32_t(bytes[1]) << 8U | std::uint32_t(bytes[2]) << 16U |
               std::uint32_t(bytes[3]) << 24U;
    }

    /// One that ends in 0, of 255 bytes at most; none where there is no such text.
    std::string text() {
        std::array<char, 256> text{};
        file_.getline(text.data(), text.size(), '\0');
        return text.data();
    }

    std::uint64_t position() { return std::uint64_t(file_.tellg()); }
    std::uint64_t left() { return size_ - position(); }
    void goTo(std::uint64_t position) { file_.seekg(std::streamoff(position)); }

  private:
    std::ifstream file_;
    std::uint64_t size_ = 0;
};

/// How many channels a list has, which ends with an empty name. Reads to its end.
std::uint64_t countChannels(Headers& headers) {
    constexpr std::uint64_t typeLinearityAndSampling = 16;
    std::uint64_t count = 0;
    while (headers && !headers.text().empty()) {
        ++count;
        headers.goTo(headers.position() + typeLinearityAndSampling);
    }
    return count;
}

/// Reads the value of an attribute that says how large the part is; of any other, nothing.
void take(Headers& headers, const std::string& name, const std::string& type, ExrClaims& claims) {
    if (name == "dataWindow" && type == "box2i") {
        const auto left = std::int32_t(headers.number());
        const auto top = std::int32_t(headers.number());
        claims.width = 1LL + std::int32_t(headers.number()) - left;
        claims.height = 1LL + std::int32_t(headers.number()) - top;
    } else if (name == "channels" && type == "chlist") {
        claims.channels = countChannels(headers);
    } else if (name == "tiles" && type == "tiledesc") {
        const double across = headers.number();
        claims.tileTexels = across * headers.number();
    }
}

/// How many bytes a value takes by its type, or by what it says of itself; `claimed` for a type
/// that leaves it to the header. Reads on from the value's first byte.
std::uint64_t sizeByType(Headers& headers, const std::string& type, std::uint64_t claimed) {
    const auto* fixed = std::find_if(kFixedTypes.begin(), kFixedTypes.end(),
                                     [&](const FixedType& known) { return known.name == type; });
    if (fixed != kFixedTypes.end()) return fixed->size;
    const std::uint64_t begin = headers.position();
    if (type == "chlist") {
        countChannels(headers);
        return headers ? headers.position() - begin : 0;
    }
    if (type == "preview") {
        const std::uint64_t width = headers.number();
        const std::uint64_t pixels = width * headers.number();
        return pixels < claimed ? 8 + 4 * pixels : pixels + 8;
    }
    if (type == "stringvector") {
        while (headers && headers.position() - begin < claimed) {
            const std::uint64_t length = headers.number();
            headers.goTo(headers.position() + length);
        }
        return headers ? headers.position() - begin : 0;
    }
    return claimed;
}

}  // namespace

std::uint64_t ExrClaims::chunkBytes() const {
    constexpr double mostLines = 256;  // of DWAB
    constexpr double largestSample = 4;
    constexpr double beyondAllMemory = 1e18;
    const double texels = tileTexels > 0 ? tileTexels : double(width) * mostLines;
    return std::uint64_t(std::min(texels * double(channels) * largestSample, beyondAllMemory));
}

std::vector<ExrClaims> checkExrAttributes(const std::string& path) {
    std::vector<ExrClaims> parts(1);
    Headers headers(path);
    headers.number();  // the signature
    const bool severalParts = (headers.number() & 0x1000U) != 0;
    std::string name = headers.text();
    while (headers && !name.empty()) {
        const std::string type = headers.text();
        const std::uint64_t claimed = headers.number();
        if (!headers) return parts;
        const std::uint64_t begin = headers.position();
        if (claimed > headers.left()) {
            throw FileError(path, "damaged: an attribute claims " + bytesText(claimed) +
                                      ", which the file does not have");
        }
        if (sizeByType(headers, type, claimed) != claimed) {
            throw FileError(path, "damaged: an attribute claims " + bytesText(claimed) +
                                      ", which its type contradicts");
        }
        headers.goTo(begin);
        take(headers, name, type, parts.back());
        headers.goTo(begin + claimed);
        name = headers.text();
        // A part's header ends with an empty name, the last one with two.
        if (name.empty() && severalParts) {
            name = headers.text();
            if (!name.empty()) parts.emplace_back();
        }
    }
    return parts;
}

}  // namespace specbake::internal
