#include "plain_png.h"

#include "png_chunks.h"
#include "png_filter.h"
#include "png_stream.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <set>
#include <string_view>

/// "PNG specification" is the W3C Recommendation of 10 November 2003.
namespace specbake {
namespace {

bool isType(const PngChunk& chunk, std::string_view type) {
    return std::equal(chunk.type.begin(), chunk.type.end(), type.begin(), type.end());
}

std::uint32_t bigEndian(std::span<const std::uint8_t> bytes) {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes.first(4)) value = value << 8 | byte;
    return value;
}

std::vector<std::uint8_t> contentsOf(const std::string& path, const PngChunk& chunk) {
    std::vector<std::uint8_t> bytes(chunk.length);
    std::ifstream in(path, std::ios::binary);
    in.seekg(std::streamoff(chunk.offset));
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!in) throw FileError(path, "truncated");
    return bytes;
}

/// The header IHDR (PNG specification, 11.2.2).
struct Header {
    std::uint32_t width, height;
    std::uint8_t bits, colorType, compression, filter, interlace;

    static constexpr std::uint32_t kLength = 13;
    explicit Header(std::span<const std::uint8_t> b)
        : width(bigEndian(b)),
          height(bigEndian(b.subspan(4))),
          bits(b[8]),
          colorType(b[9]),
          compression(b[10]),
          filter(b[11]),
          interlace(b[12]) {}

    bool hasColor() const { return (colorType & 2) != 0; }
    bool hasAlpha() const { return (colorType & 4) != 0; }
    int channels() const { return (hasColor() ? 3 : 1) + (hasAlpha() ? 1 : 0); }
    bool isPlain() const {
        const bool noPalette = colorType == 0 || colorType == 2 || colorType == 4 || colorType == 6;
        return noPalette && (bits == 8 || bits == 16) && compression == 0 && filter == 0 &&
               interlace == 0;
    }
};

/// A gAMA of 1/2.2 says what is assumed anyhow (PNG specification, 11.3.3).
bool isGammaOfSRGB(std::span<const std::uint8_t> data) {
    constexpr std::uint32_t gamma = 45455;  // 100000 / 2.2
    return data.size() == 4 && bigEndian(data) == gamma;
}

/// So does a cHRM of the primaries of sRGB (PNG specification, 11.3.3): x and y of white, red,
/// green and blue, times 100000.
bool isPrimariesOfSRGB(std::span<const std::uint8_t> data) {
    constexpr std::array<std::uint32_t, 8> primaries = {31270, 32900, 64000, 33000,
                                                        30000, 60000, 15000, 6000};
    if (data.size() != 4 * primaries.size()) return false;
    for (std::size_t i = 0; i < primaries.size(); ++i) {
        if (bigEndian(data.subspan(4 * i)) != primaries[i]) return false;
    }
    return true;
}

/// An offset (extensions to the PNG specification, oFFs) of none.
bool isNoOffset(std::span<const std::uint8_t> data) {
    return data.size() == 9 && bigEndian(data) == 0 && bigEndian(data.subspan(4)) == 0;
}

/// The time of a tIME chunk (PNG specification, 11.3.6.1) as Exif writes it; nothing for no time.
std::optional<std::string> dateTime(std::span<const std::uint8_t> t) {
    if (t.size() != 7) return {};
    const bool valid = t[2] >= 1 && t[2] <= 12 && t[3] >= 1 && t[3] <= 31 && t[4] <= 23 &&
                       t[5] <= 59 && t[6] <= 60;
    if (!valid) return {};
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%4d:%02d:%02d %02d:%02d:%02d", t[0] << 8 | t[1], t[2],
                  t[3], t[4], t[5], t[6]);
    return text.data();
}

/// Takes over what a chunk says beside the pixels; false if that is anything but plain.
bool takeOver(const PngChunk& chunk, std::span<const std::uint8_t> data, Attributes& attributes) {
    if (isType(chunk, "sRGB")) return data.size() == 1;
    if (isType(chunk, "gAMA")) return isGammaOfSRGB(data);
    if (isType(chunk, "cHRM")) return isPrimariesOfSRGB(data);
    if (isType(chunk, "oFFs")) return isNoOffset(data);
    if (!isType(chunk, "tIME")) return false;
    const auto time = dateTime(data);
    if (time) attributes["DateTime"] = *time;
    return time.has_value();
}

/// A plain file's pixel chunks and its metadata.
struct PlainParts {
    std::vector<PngChunk> pixels;
    Attributes attributes;
};

/// Nothing if any chunk is not plain, stands where it should not or twice.
std::optional<PlainParts> plainParts(const std::string& path, const std::vector<PngChunk>& chunks) {
    constexpr std::uint32_t longestPlain = 32;  // cHRM
    const auto hasPixels = [](const PngChunk& chunk) { return isType(chunk, "IDAT"); };
    const auto first = std::find_if(chunks.begin(), chunks.end(), hasPixels);
    const auto last = std::find_if_not(first, chunks.end(), hasPixels);
    if (last == chunks.end() || !isType(*last, "IEND")) return {};
    PlainParts parts{{first, last}, {}};
    std::set<std::array<char, 4>> types;
    for (auto chunk = chunks.begin() + 1; chunk != first; ++chunk) {
        if (chunk->length > longestPlain || !types.insert(chunk->type).second) return {};
        if (!takeOver(*chunk, contentsOf(path, *chunk), parts.attributes)) return {};
    }
    return parts;
}

ImageDescription describe(const Header& header, Attributes attributes) {
    ImageDescription d;
    d.data = {0, 0, int(header.width), int(header.height)};
    d.display = d.data;
    d.channels =
        header.hasColor() ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
    if (header.hasAlpha()) {
        d.alpha = int(d.channels.size());
        d.channels.emplace_back("A");
    }
    d.sampleType = header.bits == 8 ? SampleType::uint8 : SampleType::uint16;
    d.attributes = std::move(attributes);
    return d;
}

class PlainPng : public ImageFile {
  public:
    PlainPng(const std::string& path, const Header& header, PlainParts parts)
        : ImageFile(describe(header, std::move(parts.attributes))),
          stream_(path, std::move(parts.pixels)),
          pixelBytes_(std::size_t(header.channels()) * header.bits / 8),
          above_(header.width * pixelBytes_),
          row_(1 + above_.size()) {}

    std::optional<std::string> text(const std::string& attribute) const override {
        const auto found = description().attributes.find(attribute);
        if (found == description().attributes.end()) return {};
        return std::get<std::string>(found->second);
    }

    void readRows(int first, int count, SampleType type, std::span<std::byte> samples) override {
        if (type != description().sampleType) throw ArgumentError("a PNG has integer samples");
        if (samples.size() < above_.size() * std::size_t(count)) {
            throw ArgumentError("a buffer too small for its rows");
        }
        if (first < nextRow_) rewind();
        while (nextRow_ < first) unpackRow();
        for (int row = 0; row < count; ++row) {
            unpackRow();
            store(samples.subspan(std::size_t(row) * above_.size(), above_.size()));
        }
    }

  private:
    void rewind() {
        stream_.rewind();
        std::fill(above_.begin(), above_.end(), std::uint8_t{0});
        nextRow_ = 0;
    }

    /// The next row into above_, which the row after it is predicted from.
    void unpackRow() {
        stream_.read(row_);
        const std::span bytes = std::span(row_).subspan(1);
        if (!unfilter(row_[0], pixelBytes_, above_, bytes)) {
            stream_.fail("damaged: a row of no known filter");
        }
        std::copy(bytes.begin(), bytes.end(), above_.begin());
        ++nextRow_;
    }

    /// PNG has the high byte first (PNG specification, 7.1).
    void store(std::span<std::byte> samples) const {
        if (description().sampleType == SampleType::uint8) {
            std::transform(above_.begin(), above_.end(), samples.begin(),
                           [](std::uint8_t byte) { return std::byte{byte}; });
            return;
        }
        for (std::size_t i = 0; i < samples.size(); i += 2) {
            const auto sample = std::uint16_t(above_[i] << 8 | above_[i + 1]);
            std::memcpy(samples.data() + i, &sample, sizeof sample);
        }
    }

    PngStream stream_;
    std::size_t pixelBytes_;
    std::vector<std::uint8_t> above_;  ///< the row before nextRow_
    std::vector<std::uint8_t> row_;    ///< the filter, and the filtered row
    int nextRow_ = 0;
};

}  // namespace

std::unique_ptr<ImageFile> openPlainPng(const std::string& path) {
    const std::vector<PngChunk> chunks = pngChunks(path);
    if (chunks.empty() || chunks[0].length != Header::kLength) return {};
    const Header header(contentsOf(path, chunks[0]));
    if (!header.isPlain()) return {};
    std::optional<PlainParts> parts = plainParts(path, chunks);
    if (!parts) return {};
    checkSides(path, header.width, header.height);
    return std::make_unique<PlainPng>(path, header, std::move(*parts));
}

}  // namespace specbake
