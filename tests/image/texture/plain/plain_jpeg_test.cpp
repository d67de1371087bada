#include "texture/plain/plain_jpeg.h"

#include "support/contents.h"
#include "support/jpeg_file.h"
#include "support/same_image.h"
#include "support/temporary_file.h"

#include <specbake/core/error.h>

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <random>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

using Random = std::mt19937;

const std::string kImages = SPECBAKE_SOURCE_DIR "/testimages/";

std::string refusal(const std::string& contents) {
    const TemporaryFile file(contents);
    try {
        const auto image = openPlainJpeg(file.path());
        if (!image) return "other";
        allOf(*image);
    } catch (const FileError& error) {
        return std::string(error.what()).substr(file.path().size());
    }
    return "none";
}

}  // namespace

TEST_CASE("other files are left to OpenImageIO") {
    for (const auto& entry : std::filesystem::directory_iterator(kImages)) {
        CAPTURE(entry.path());
        const bool isJpeg = entry.path().extension() == ".jpg";
        CHECK((openPlainJpeg(entry.path().string()) != nullptr) == isJpeg);
    }
}

TEST_CASE("any size and quality, grey or colour, subsampled or not, reads the same") {
    Random random(1);
    const auto below = [&](int end) { return std::uniform_int_distribution(0, end - 1)(random); };
    const TemporaryFile file("", ".jpg");
    for (int i = 0; i < 100; ++i) {
        CAPTURE(i);
        OIIO::ImageSpec spec(1 + below(60), 1 + below(60), below(2) == 0 ? 1 : 3, OIIO::TypeUInt8);
        spec.attribute("CompressionQuality", 1 + below(100));
        if (spec.nchannels == 3) {
            const char* const subsamplings[] = {"4:4:4", "4:2:2", "4:2:0", "4:1:1"};
            spec.attribute("jpeg:subsampling", subsamplings[below(4)]);
        }
        if (below(2) == 0) spec.attribute("jpeg:progressive", 1);
        std::vector<unsigned char> pixels(spec.image_pixels() * std::size_t(spec.nchannels));
        for (auto& sample : pixels) sample = static_cast<unsigned char>(below(256));
        const auto output = OIIO::ImageOutput::create(file.path());
        REQUIRE(output->open(file.path(), spec));
        REQUIRE(output->write_image(OIIO::TypeUInt8, pixels.data()));
        REQUIRE(output->close());
        const std::string contents = withoutMetadata(contentsOf(file.path()));
        std::ofstream(file.path(), std::ios::binary) << contents;
        const auto image = openPlainJpeg(file.path());
        REQUIRE(image);
        checkSameAsOpenImageIO(*image, file.path());
    }
}

TEST_CASE("what stands beside the pixels reads the same") {
    struct Segments {
        std::string bytes;
        bool plain;
    };
    const std::string exif("Exif\0\0MM\0*\0\0\0\10\0\0\0\0\0\0", 20);
    const std::string iptc("Photoshop 3.0\0008BIM\4\4\0\0\0\0\0\0", 26);
    const std::string clipping("Photoshop 3.0\0008BIM\7\320\0\0\0\0\0\0", 26);
    const Segments all[] = {{"", true},
                            {jfifSegment(0, 1, 1), true},
                            {jfifSegment(1, 72, 72), true},
                            {jfifSegment(2, 28, 28), true},
                            {jfifSegment(0, 2, 1), true},
                            {jfifSegment(1, 300, 150), true},
                            {jfifSegment(1, 0, 72), true},
                            {jfifSegment(7, 30, 30), true},
                            {jpegSegment(0xfe, "a comment"), true},
                            {jpegSegment(0xfe, std::string("ends in zero\0", 13)), true},
                            {jpegSegment(0xfe, "one") + jpegSegment(0xfe, "two"), true},
                            {jpegSegment(0xfe, "key:value") + jpegSegment(0xfe, "a:b:c"), true},
                            {jpegSegment(0xe2, std::string("ICC_PROFILE\0\1\1profile", 21)), true},
                            {jpegSegment(0xe5, "unknown"), true},
                            {jpegSegment(0xe1, exif), true},
                            {jpegSegment(0xe1, std::string("Exif\0\0", 6)), true},
                            {jpegSegment(0xe1, "of another program"), true},
                            {jpegSegment(0xe1, "http://ns.adobe.com/xap/1.0/"), false},
                            {jpegSegment(0xed, clipping), true},
                            {jpegSegment(0xed, iptc), false}};
    for (const Segments& segments : all) {
        CAPTURE(segments.bytes);
        const TemporaryFile file(jpegWithSegments(segments.bytes), ".jpg");
        const auto image = openPlainJpeg(file.path());
        REQUIRE((image != nullptr) == segments.plain);
        if (image) checkSameAsOpenImageIO(*image, file.path());
    }
}

TEST_CASE("rows may be asked for in any order") {
    const TemporaryFile file(plainJpeg(), ".jpg");
    const auto image = openPlainJpeg(file.path());
    REQUIRE(image);
    const std::vector<std::byte> all = allOf(*image);
    const int height = image->description().data.height;
    const std::ptrdiff_t rowBytes = std::ptrdiff_t(all.size()) / height;
    for (const int first : {height - 1, 0, height / 2, 1, height / 2 + 1}) {
        const auto begin = all.begin() + first * rowBytes;
        CHECK(rowsOf(*image, first, 1) == std::vector<std::byte>(begin, begin + rowBytes));
    }
}

TEST_CASE("a file that is cut anywhere is refused, whatever libjpeg would make up") {
    const std::string whole = plainJpeg();
    for (std::size_t size = 3; size < whole.size(); ++size) {
        CAPTURE(size);
        CHECK(refusal(whole.substr(0, size)).starts_with(": JPEG: "));
    }
}

TEST_CASE("no damage does more than to be refused or to change pixels") {
    Random random(2);
    const std::string whole = plainJpeg();
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = whole;
        const std::size_t at =
            std::uniform_int_distribution<std::size_t>(3, whole.size() - 1)(random);
        damaged[at] = char(random() & 255);
        const std::string said = refusal(damaged);
        CAPTURE(said);
        CHECK((said == "none" || said == "other" || said.starts_with(": JPEG: ") ||
               said.starts_with(": a side of more than ")));
    }
}
