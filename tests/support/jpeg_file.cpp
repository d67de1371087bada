#include "support/jpeg_file.h"

#include "support/contents.h"

#include <doctest/doctest.h>

namespace specbake::testing {

std::string jpegSegment(int marker, const std::string& data) {
    const std::size_t length = data.size() + 2;
    return std::string{'\xff', char(marker), char(length >> 8), char(length & 255)} + data;
}

std::string jfifSegment(char unit, int x, int y) {
    const auto two = [](int n) { return std::string{char(n >> 8), char(n & 255)}; };
    return jpegSegment(
        0xe0, std::string("JFIF\0\1\2", 7) + unit + two(x) + two(y) + std::string("\0\0", 2));
}

std::string withoutMetadata(const std::string& jpeg) {
    const auto byte = [&](std::size_t i) {
        return std::size_t(static_cast<unsigned char>(jpeg[i]));
    };
    std::string kept = jpeg.substr(0, 2);
    std::size_t at = 2;
    while (byte(at + 1) != 0xda) {
        const std::size_t end = at + 2 + byte(at + 2) * 256 + byte(at + 3);
        if ((byte(at + 1) & 0xf0) != 0xe0 || byte(at + 1) == 0xe0) {
            kept += jpeg.substr(at, end - at);
        }
        at = end;
    }
    return kept + jpeg.substr(at);
}

std::string plainJpeg() {
    return withoutMetadata(contentsOf(SPECBAKE_SOURCE_DIR "/testimages/rgb8.jpg"));
}

std::string jpegWithSegments(const std::string& segments) {
    const std::string whole = plainJpeg();
    constexpr std::size_t jfifEnd = 2 + 18;
    REQUIRE(whole.substr(6, 4) == "JFIF");
    return whole.substr(0, 2) + segments + whole.substr(jfifEnd);
}

}  // namespace specbake::testing
