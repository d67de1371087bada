#include "texture/plain/exif_block.h"

#include "support/below.h"
#include "support/jpeg_file.h"
#include "support/png_file.h"
#include "support/same_image.h"
#include "support/temporary_file.h"
#include "texture/image_file.h"
#include "texture/plain/plain_jpeg.h"
#include "texture/plain/plain_png.h"

#include <OpenImageIO/tiffutils.h>
#include <doctest/doctest.h>

#include <random>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

using Random = std::mt19937;

/// One entry of a directory (TIFF 6.0, section 2).
struct Entry {
    int tag;
    int type;
    unsigned count;
    std::string value;  ///< in the byte order of the file
};

/// Writes directories in one byte order.
class Writer {
  public:
    explicit Writer(bool littleEndian) : little_(littleEndian) {}

    std::string number(std::uint64_t value, int bytes) const {
        std::string text = bigEndian(value, bytes);
        if (little_) std::reverse(text.begin(), text.end());
        return text;
    }

    /// A TIFF header and its first directory, from which two others are reached.
    std::string block(std::vector<Entry> first, const std::vector<Entry>& exif,
                      const std::vector<Entry>& gps) const {
        constexpr std::size_t header = 8;
        first.push_back({0x8769, 4, 1, number(0, 4)});
        first.push_back({0x8825, 4, 1, number(0, 4)});
        const std::size_t exifAt = header + directory(first, header).size();
        const std::size_t gpsAt = exifAt + directory(exif, exifAt).size();
        first[first.size() - 2].value = number(exifAt, 4);
        first[first.size() - 1].value = number(gpsAt, 4);
        return std::string(little_ ? "II" : "MM") + number(42, 2) + number(header, 4) +
               directory(first, header) + directory(exif, exifAt) + directory(gps, gpsAt);
    }

  private:
    std::string directory(const std::vector<Entry>& entries, std::size_t at) const {
        std::string text = number(entries.size(), 2);
        std::string values;
        const std::size_t valuesAt = at + 2 + 12 * entries.size() + 4;
        for (const Entry& entry : entries) {
            text += number(std::uint64_t(entry.tag), 2) + number(std::uint64_t(entry.type), 2) +
                    number(entry.count, 4);
            if (entry.value.size() <= 4) {
                text += entry.value + std::string(4 - entry.value.size(), '\0');
            } else {
                text += number(valuesAt + values.size(), 4);
                values += entry.value + std::string(entry.value.size() % 2, '\0');
            }
        }
        return text + number(0, 4) + values;
    }

    bool little_;
};

constexpr int kByte = 1, kAscii = 2, kShort = 3, kLong = 4, kRational = 5, kUndefined = 7,
              kSignedRational = 10;
constexpr int kImageDescription = 0x10e, kOrientation = 0x112, kXResolution = 0x11a,
              kYResolution = 0x11b;

std::string randomText(Random& random) {
    std::string text;
    const int size = below(random, 12);
    for (int i = 0; i < size; ++i) text += char(' ' + below(random, 94));
    if (below(random, 4) == 0) text += std::string("\0rest", 5);
    return text + std::string(std::size_t(below(random, 3)), '\0');
}

/// Of the type that the tag has by its standard, and now and then of another.
Entry randomEntry(Random& random, const Writer& writer, int tag, int standardType) {
    constexpr int types[] = {kByte, kAscii, kShort, kLong, kRational, kUndefined, kSignedRational};
    constexpr unsigned counts[] = {1, 1, 1, 1, 2, 3, 4, 9, 16};
    // Of these OpenImageIO takes the first of several numbers, fractions for whole ones, and a
    // comment for what is no text.
    const bool strict = tag == kOrientation || tag == kXResolution || tag == kYResolution ||
                        tag == kImageDescription;
    const bool odd = below(random, 5) == 0 && !strict;
    const int type = odd ? types[below(random, 7)] : standardType;
    Entry entry{tag, type, strict ? 1 : counts[below(random, 9)], ""};
    if (type == kAscii) {
        entry.value = randomText(random) + '\0';
        entry.count = unsigned(entry.value.size());
        return entry;
    }
    const int size = type == kByte || type == kUndefined ? 1 : type == kShort ? 2 : 4;
    const unsigned numbers = type == kRational || type == kSignedRational ? 2 : 1;
    for (unsigned i = 0; i < entry.count * numbers; ++i) {
        const std::uint64_t mask =
            below(random, 2) == 0 ? 0xff : (std::uint64_t(1) << 8 * size) - 1;
        entry.value += writer.number(std::max<std::uint64_t>(random() & mask, 1), size);
    }
    return entry;
}

std::vector<Entry> randomEntries(Random& random, const Writer& writer, OIIO::string_view table,
                                 bool ofFirst) {
    std::vector<Entry> entries;
    for (const OIIO::TagInfo& tag : OIIO::tag_table(std::string(table))) {
        const bool isDirectory =
            tag.tifftag == 0x8769 || tag.tifftag == 0x8825 || tag.tifftag == 0xa005;
        const bool first = tag.tifftag < 0x8000 || tag.tifftag == 0x8298;
        // The tag of PhotographicSensitivity stands in the table under an older name, too.
        if (std::string_view(tag.name) == "Exif:ISOSpeedRatings") continue;
        if (isDirectory || (table == "Exif" && first != ofFirst) || below(random, 3) != 0) continue;
        const int type = tag.tifftype == 0 ? kShort : int(tag.tifftype);
        entries.push_back(randomEntry(random, writer, tag.tifftag, type));
    }
    return entries;
}

std::string randomBlock(Random& random) {
    const Writer writer(below(random, 2) == 0);
    return writer.block(randomEntries(random, writer, "Exif", true),
                        randomEntries(random, writer, "Exif", false),
                        randomEntries(random, writer, "GPS", false));
}

/// Exif, behind what else speaks of the resolution, and before or behind a comment.
std::string randomSegments(Random& random) {
    const std::string jfif[] = {"", jfifSegment(1, 72, 72), jfifSegment(0, 1, 1),
                                jfifSegment(2, 0, 1)};
    std::string segments = jfif[below(random, 4)];
    if (below(random, 4) == 0) segments += jpegSegment(0xfe, "a comment");
    segments += jpegSegment(0xe1, std::string("Exif\0\0", 6) + randomBlock(random));
    if (below(random, 4) == 0) segments += jpegSegment(0xfe, "a comment");
    return segments;
}

/// Texts and a resolution, of which Exif may speak too.
std::string randomChunks(Random& random) {
    const std::string texts[] = {"Description", "Author", "Copyright", "Model", "Make"};
    std::string chunks;
    if (below(random, 2) == 0) chunks += pngChunk("pHYs", std::string("\0\0\7\10\0\0\6\10\1", 9));
    if (below(random, 2) == 0) {
        chunks += pngChunk("tEXt", texts[below(random, 5)] + '\0' + "a text");
    }
    const std::string exif = pngChunk("eXIf", randomBlock(random));
    return below(random, 2) == 0 ? chunks + exif : exif + chunks;
}

}  // namespace

TEST_CASE("the maker notes of Canon are left to OpenImageIO") {
    const Writer writer(true);
    for (const std::string make : {"Canon", "Nikon"}) {
        const Entry ours{0x10f, kAscii, 6, make + '\0'};
        const Entry note{0x927c, kUndefined, 8, "12345678"};
        CHECK(readExif(writer.block({ours}, {note}, {})).has_value() == (make != "Canon"));
        CHECK(readExif(writer.block({ours}, {}, {})).has_value());
    }
}

TEST_CASE("a block that is cut or damaged says less, or something else, and no more than that") {
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        std::string block = randomBlock(random);
        CHECK(readExif(block.substr(0, std::size_t(below(random, int(block.size()))))).has_value());
        for (int change = 0; change < 8; ++change) {
            block[std::size_t(below(random, int(block.size())))] = char(below(random, 256));
            static_cast<void>(readExif(block));
        }
    }
}

TEST_CASE("a JPEG with Exif reads as OpenImageIO reads it, whatever Exif says") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        CAPTURE(i);
        const TemporaryFile file(jpegWithSegments(randomSegments(random)), ".jpg");
        const auto image = openPlainJpeg(file.path());
        REQUIRE(image);
        checkSameAsOpenImageIO(*image, file.path());
    }
}

TEST_CASE("a PNG with Exif, too") {
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        CAPTURE(i);
        PngFile png;
        png.packed = zlibStream(std::string(1 + png.rowBytes(), '\0'));
        png.before = randomChunks(random);
        const TemporaryFile file(png.contents(), ".png");
        const auto image = openPlainPng(file.path());
        REQUIRE(image);
        checkSameAsOpenImageIO(*image, file.path());
    }
}
