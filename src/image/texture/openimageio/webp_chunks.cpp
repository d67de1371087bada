#include "texture/openimageio/webp_chunks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

namespace specbake::internal {
namespace {

/// Bytes as numbers; 0 beyond their end.
class Bytes {
  public:
    Bytes(std::string_view bytes, bool bigEndian) : bytes_(bytes), bigEndian_(bigEndian) {}

    std::uint32_t number(std::size_t at, std::size_t size) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i) {
            value = value << 8U | byte(at + (bigEndian_ ? i : size - 1 - i));
        }
        return value;
    }

  private:
    std::uint32_t byte(std::size_t at) const {
        return at < bytes_.size() ? std::uint32_t(static_cast<unsigned char>(bytes_[at])) : 0;
    }
    std::string_view bytes_;
    bool bigEndian_;
};

/// Of the first directory of Exif data, which are a TIFF file (TIFF 6.0, section 2): a count, then
/// entries of 12 bytes: tag, type, count, value.
int orientationIn(std::string_view exif) {
    constexpr std::uint32_t tag = 274;
    const Bytes tiff(exif, exif.starts_with("MM"));
    const std::size_t directory = tiff.number(4, 4);
    const std::size_t entries = tiff.number(directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (tiff.number(entry, 2) == tag) return int(tiff.number(entry + 8, 2));
    }
    return 1;
}

/// The head of a RIFF chunk: four letters, and the size of what follows.
struct ChunkHead {
    std::array<char, 8> bytes;
    std::string_view name() const { return {bytes.data(), 4}; }
    std::uint32_t size() const { return Bytes({bytes.data(), bytes.size()}, false).number(4, 4); }
};

std::optional<ChunkHead> nextChunk(std::istream& in) {
    ChunkHead head{};
    in.read(head.bytes.data(), std::streamsize(head.bytes.size()));
    if (!in) return {};
    return head;
}

/// The content of a chunk; empty if there is none of bounded size.
std::string chunkOf(const std::string& path, std::string_view name) {
    constexpr std::uint32_t mostBytes = 1U << 24U;
    std::ifstream in(path, std::ios::binary);
    in.seekg(12);  // "RIFF", a size, "WEBP"
    while (const auto head = nextChunk(in)) {
        const std::uint32_t size = head->size();
        if (head->name() == name && size <= mostBytes) {
            std::string content(size, '\0');
            in.read(content.data(), std::streamsize(size));
            return in ? content : std::string();
        }
        in.seekg(std::streamoff(size) + size % 2, std::ios::cur);  // chunks begin at even places
    }
    return {};
}

}  // namespace

int webpOrientation(const std::string& path) {
    const std::string content = chunkOf(path, "EXIF");
    std::string_view exif = content;
    constexpr std::string_view ofJpeg("Exif\0\0", 6);  // some programs write it here too
    if (exif.starts_with(ofJpeg)) exif.remove_prefix(ofJpeg.size());
    return orientationIn(exif);
}

std::string webpProfile(const std::string& path) {
    return chunkOf(path, "ICCP");
}

}  // namespace specbake::internal
