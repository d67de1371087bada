#pragma once

#include "file/input_stream.h"
#include "texture/image_file.h"

#include <png.h>

#include <array>
#include <string>

namespace specbake::internal {

/// A PNG, read by libpng row by row: palettes become RGB, a transparent colour becomes alpha, and
/// samples of fewer than 8 bits become 8. Stands before the first row when made.
class PngDecoder {
  public:
    /// Throws FileError for what is no PNG, or none of bounded size.
    explicit PngDecoder(const std::string& path);
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;

    const ImageDescription& description() const { return description_; }

    /// Interlaced rows come in seven passes, not one after the other.
    bool isInterlaced() const;
    /// What OpenImageIO alone knows how to read: XMP, Exif in a text, the maker notes of Canon.
    bool hasRichMetadata() const { return hasRichMetadata_; }

    /// Throws FileError; with the last row also for a file that is cut after it.
    void readRow(std::byte* samples);

  private:
    /// What libpng calls its read struct and its info struct.
    struct Structs {
        Structs() = default;
        ~Structs() { png_destroy_read_struct(&read, &info, nullptr); }
        Structs(const Structs&) = delete;
        Structs& operator=(const Structs&) = delete;

        png_structp read = nullptr;
        png_infop info = nullptr;
    };
    template <class Call>
    void guarded(Call&& call);
    [[noreturn]] void fail() const;
    [[noreturn]] static void onError(png_structp png, png_const_charp message);
    static void onWarning(png_structp png, png_const_charp message);
    void readHeader();
    void describe();
    void readColorChunks();
    void readMetadata();
    void readExifChunk();
    void readText(const char* key, const std::string& text);

    std::string path_;
    InputStream stream_;
    std::array<char, 128> message_{};  ///< what libpng said last
    Structs png_;
    ImageDescription description_;
    bool hasRichMetadata_ = false;
    int rowsRead_ = 0;
};

}  // namespace specbake::internal
