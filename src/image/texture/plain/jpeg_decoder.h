#pragma once

#include "file/input_stream.h"
#include "texture/image_file.h"

#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it before
#include <string>
#include <string_view>

namespace specbake::internal {

/// A grey, RGB or CMYK JPEG, read by libjpeg row by row. Stands before the first row when made.
class JpegDecoder {
  public:
    /// Throws FileError for what is no JPEG, or none of bounded size.
    explicit JpegDecoder(const std::string& path);
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;

    const ImageDescription& description() const { return description_; }

    /// Of one, three or four components, and no metadata that OpenImageIO alone knows how to read
    /// (XMP, IPTC, the maker notes of Canon, a second block of Exif).
    bool isPlain() const { return plain_; }
    bool hasInks() const { return jpeg_.num_components == 4; }

    /// Throws FileError, also where data lack or are damaged so that libjpeg would make them up.
    void readRow(std::byte* samples);

  private:
    /// Where libjpeg goes when a call cannot go on. The first member is what it knows.
    struct Errors {
        jpeg_error_mgr manager;
        std::jmp_buf leave;
        std::array<char, JMSG_LENGTH_MAX> message;
        bool lenient;     ///< a warning does not end the call
        bool complained;  ///< there was one meanwhile
    };
    /// All zero, as jpeg_destroy_decompress() wants one that was not created.
    struct Decompressor : jpeg_decompress_struct {
        Decompressor() : jpeg_decompress_struct{} {}
        ~Decompressor() { jpeg_destroy_decompress(this); }
        Decompressor(const Decompressor&) = delete;
        Decompressor& operator=(const Decompressor&) = delete;
    };
    template <class Call>
    void guarded(Call&& call);
    [[noreturn]] void fail() const;
    [[noreturn]] static void onError(j_common_ptr jpeg);
    static void onMessage(j_common_ptr jpeg, int level);
    void readHeader();
    void describe();
    void readProfile();
    void readMarkers();
    void readExifOrXmp(std::string_view data);
    void readDensity();

    std::string path_;
    InputStream stream_;
    Errors errors_{};
    Decompressor jpeg_;
    ImageDescription description_;
    bool plain_ = true;
    bool hasExif_ = false;
};

}  // namespace specbake::internal
