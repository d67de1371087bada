#include "texture/plain/png_decoder.h"

#include "texture/color/png_signs.h"
#include "texture/kept_metadata.h"
#include "texture/plain/exif_block.h"

#include <specbake/core/error.h>

#include <strings.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>

namespace specbake::internal {
namespace {

/// What says how the numbers are meant. Read as they are stored: libpng would judge them, and drop
/// what it does not like.
constexpr std::string_view kColorChunks("cICP\0iCCP\0sRGB\0gAMA\0cHRM\0", 25);
constexpr int kColorChunkCount = 5;

std::string_view nameOf(const png_unknown_chunk& chunk) {
    return {reinterpret_cast<const char*>(chunk.name), 4};
}

bool sameWord(const char* a, const char* b) {
    return strcasecmp(a, b) == 0;
}

float perInch(png_uint_32 perMetre) {
    return float(perMetre) * (2.54F / 100.0F);
}

/// libpng (1.6.39) allocates some chunks by the length that they claim. What else is wrong, it says
/// itself. The file stands at its beginning, and does so again.
void checkChunks(const std::string& path, std::FILE* file) {
    std::fseek(file, 0, SEEK_END);
    const long size = std::ftell(file);
    std::array<png_byte, 8> head{};  // the signature; length and name of a chunk
    constexpr long checksum = 4;
    for (long at = long(head.size()); std::fseek(file, at, SEEK_SET) == 0;) {
        if (std::fread(head.data(), head.size(), 1, file) != 1) break;
        if (std::memcmp(&head[4], "IDAT", 4) == 0) break;  // comes in pieces
        const png_uint_32 claimed = png_get_uint_32(head.data());
        at += long(head.size());
        if (long(claimed) > size - at) throw FileError(path, "PNG: a chunk longer than the file");
        at += long(claimed) + checksum;
    }
    std::rewind(file);
}

}  // namespace

/// libpng leaves a call that went wrong by longjmp, past frames that own nothing.
template <class Call>
void PngDecoder::guarded(Call&& call) {
    if (setjmp(png_jmpbuf(png_.read)) != 0) fail();
    call();
}

void PngDecoder::fail() const {
    throw FileError(path_, std::string("PNG: ") + message_.data());
}

/// libpng goes on after a warning, without the chunk that it is about.
void PngDecoder::onWarning(png_structp png, png_const_charp message) {
    auto& self = *static_cast<PngDecoder*>(png_get_error_ptr(png));
    const std::string_view name = std::string_view(message).substr(0, 4);
    if (self.rowsRead_ > 0 || kColorChunks.find(name) == std::string_view::npos) return;
    self.description_.notes.push_back("PNG: " + std::string(message));
}

void PngDecoder::onError(png_structp png, png_const_charp message) {
    auto& said = static_cast<PngDecoder*>(png_get_error_ptr(png))->message_;
    std::snprintf(said.data(), said.size(), "%s", message);
    png_longjmp(png, 1);
}

PngDecoder::PngDecoder(const std::string& path) : path_(path), stream_(openStream(path)) {
    png_.read = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
    png_.info = png_.read == nullptr ? nullptr : png_create_info_struct(png_.read);
    if (png_.info == nullptr) throw FileError(path_, "PNG: libpng cannot be used");
    readHeader();
    describe();
    readColorChunks();
    readMetadata();
}

void PngDecoder::readHeader() {
    checkChunks(path_, stream_.get());
    guarded([this] {
        png_init_io(png_.read, stream_.get());
        png_set_user_limits(png_.read, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // checkSides() has ours
        png_set_keep_unknown_chunks(png_.read, PNG_HANDLE_CHUNK_ALWAYS,
                                    reinterpret_cast<png_const_bytep>(kColorChunks.data()),
                                    kColorChunkCount);
        png_read_info(png_.read, png_.info);
        png_set_expand(png_.read);
        if (std::endian::native == std::endian::little) png_set_swap(png_.read);
    });
    checkSides(path_, png_get_image_width(png_.read, png_.info),
               png_get_image_height(png_.read, png_.info));
    if (!isInterlaced()) {
        guarded([this] { png_read_update_info(png_.read, png_.info); });
    }
}

bool PngDecoder::isInterlaced() const {
    return png_get_interlace_type(png_.read, png_.info) != PNG_INTERLACE_NONE;
}

void PngDecoder::describe() {
    ImageDescription& d = description_;
    d.data = {png_get_x_offset_pixels(png_.read, png_.info),
              png_get_y_offset_pixels(png_.read, png_.info),
              int(png_get_image_width(png_.read, png_.info)),
              int(png_get_image_height(png_.read, png_.info))};
    if (isFarOut(d.data)) {
        d.data.x = d.data.y = 0;
        d.notes.emplace_back("its offset is beyond what an EXR can say, and not used");
    }
    d.display = {0, 0, d.data.width, d.data.height};
    const int channels = png_get_channels(png_.read, png_.info);
    d.channels =
        channels < 3 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    if (channels == 2 || channels == 4) {
        d.alpha = int(d.channels.size());
        d.channels.emplace_back("A");
    }
    d.sampleType =
        png_get_bit_depth(png_.read, png_.info) == 16 ? TexelType::uint16 : TexelType::uint8;
}

void PngDecoder::readText(const char* key, const std::string& text) {
    if (sameWord(key, "XML:com.adobe.xmp") || sameWord(key, "Raw profile type exif")) {
        hasRichMetadata_ = true;
    } else if (sameWord(key, "Description")) {
        description_.attributes["ImageDescription"] = text;
    } else if (sameWord(key, "Author")) {
        description_.attributes["Artist"] = text;
    } else if (sameWord(key, "Title")) {
        description_.attributes["DocumentName"] = text;
    } else if (isKeptMetadata(key)) {
        description_.attributes[key] = text;
    }
}

void PngDecoder::readColorChunks() {
    png_unknown_chunkp chunks = nullptr;
    const int count = png_get_unknown_chunks(png_.read, png_.info, &chunks);
    for (const png_unknown_chunk& chunk : std::span(chunks, std::size_t(count))) {
        const std::string_view data(reinterpret_cast<const char*>(chunk.data), chunk.size);
        readPngColorChunk(nameOf(chunk), data, description_.signs, description_.notes);
    }
}

/// Under the names that other formats have, so that they mean the same in an EXR.
void PngDecoder::readMetadata() {
    readExifChunk();  // what PNG's own chunks say goes before it
    Attributes& attributes = description_.attributes;
    png_timep t = nullptr;
    if (png_get_tIME(png_.read, png_.info, &t) != 0) {
        std::array<char, 32> time{};
        std::snprintf(time.data(), time.size(), "%4d:%02d:%02d %02d:%02d:%02d", t->year, t->month,
                      t->day, t->hour, t->minute, t->second);
        attributes["DateTime"] = std::string(time.data());
    }
    png_textp texts = nullptr;
    const int count = png_get_text(png_.read, png_.info, &texts, nullptr);
    for (int i = 0; i < count; ++i) readText(texts[i].key, texts[i].text);
    png_uint_32 x = 0;
    png_uint_32 y = 0;
    int unit = 0;
    if (png_get_pHYs(png_.read, png_.info, &x, &y, &unit) != 0) {
        const bool metric = unit == PNG_RESOLUTION_METER;
        attributes["ResolutionUnit"] = std::string(metric ? "inch" : "none");
        attributes["XResolution"] = metric ? perInch(x) : float(x);
        attributes["YResolution"] = metric ? perInch(y) : float(y);
        const float aspect = png_get_pixel_aspect_ratio(png_.read, png_.info);
        if (aspect != 0) description_.pixelAspectRatio = aspect;
    }
}

void PngDecoder::readExifChunk() {
    png_uint_32 size = 0;
    png_bytep bytes = nullptr;
    if (png_get_eXIf_1(png_.read, png_.info, &size, &bytes) == 0) return;
    auto exif = readExif({reinterpret_cast<const char*>(bytes), size});
    hasRichMetadata_ = !exif;
    if (!exif) return;
    description_.attributes = std::move(exif->attributes);
    description_.orientation = exif->orientation;
}

void PngDecoder::readRow(std::byte* samples) {
    guarded([&] { png_read_row(png_.read, reinterpret_cast<png_bytep>(samples), nullptr); });
    if (++rowsRead_ < description_.data.height) return;
    guarded([this] { png_read_end(png_.read, nullptr); });
}

}  // namespace specbake::internal
