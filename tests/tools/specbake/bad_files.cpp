#include "bad_files.h"

#include "process.h"
#include "read_back.h"

#include <OpenImageIO/deepdata.h>
#include <libdeflate.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace specbake::testing {
namespace {

/// `bytes` of an integer, the least significant first.
std::string little(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += char(value >> (8 * i));
    return text;
}

std::string big(std::uint64_t value, int bytes) {
    const std::string text = little(value, bytes);
    return {text.rbegin(), text.rend()};
}

BadFile made(const std::string& folder, const std::string& name, const std::string& contents,
             const std::string& says = "") {
    writeFile(folder + "/" + name, contents);
    return {folder + "/" + name, says};
}

std::string pngChunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    return big(data.size(), 4) + body + big(libdeflate_crc32(0, body.data(), body.size()), 4);
}

/// 8-bit RGB with a pixel stream that ends at once.
std::string pngOfSize(std::uint32_t width, std::uint32_t height) {
    const std::string header = big(width, 4) + big(height, 4) + std::string("\x08\x02\0\0\0", 5);
    const std::string nothing = "\x78\x01\x01" + std::string("\0\0\xff\xff\0\0\0\1", 8);
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + pngChunk("IDAT", nothing) +
           pngChunk("IEND", "");
}

/// BITMAPINFOHEADER, 24 bits (Windows GDI documentation).
std::string bmpOfSize(std::uint32_t width, std::uint32_t height) {
    return "BM" + little(1000, 4) + little(0, 4) + little(54, 4) + little(40, 4) +
           little(width, 4) + little(height, 4) + little(1, 2) + little(24, 2) +
           std::string(24, '\0');
}

/// Little-endian TIFF, 8-bit RGB, one strip (TIFF 6.0, section 2).
std::string tiffOfSize(std::uint32_t width, std::uint32_t height) {
    const auto entry = [](int tag, int type, std::uint32_t value) {
        return little(std::uint64_t(tag), 2) + little(std::uint64_t(type), 2) + little(1, 4) +
               little(value, 4);
    };
    return "II" + little(42, 2) + little(8, 4) + little(9, 2) + entry(256, 4, width) +
           entry(257, 4, height) + entry(258, 3, 8) + entry(259, 3, 1) + entry(262, 3, 2) +
           entry(273, 4, 200) + entry(277, 3, 3) + entry(278, 4, height) + entry(279, 4, 64) +
           little(0, 4) + std::string(200, '\0');
}

/// A scan-line EXR of half R, G, B without compression (OpenEXR file layout).
std::string exrOfSize(std::int32_t width, std::int32_t height) {
    const auto attribute = [](const std::string& name, const std::string& type,
                              const std::string& value) {
        return name + '\0' + type + '\0' + little(value.size(), 4) + value;
    };
    std::string channels;
    for (const char* name : {"B", "G", "R"}) {
        channels +=
            std::string(name) + '\0' + little(1, 4) + little(0, 4) + little(1, 4) + little(1, 4);
    }
    const std::string window =
        little(0, 8) + little(std::uint32_t(width - 1), 4) + little(std::uint32_t(height - 1), 4);
    const std::string one = little(0x3f800000, 4);  // 1.0
    return "\x76\x2f\x31\x01" + little(2, 4) + attribute("channels", "chlist", channels + '\0') +
           attribute("compression", "compression", std::string(1, '\0')) +
           attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) +
           attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", one) +
           attribute("screenWindowCenter", "v2f", little(0, 8)) +
           attribute("screenWindowWidth", "float", one) + '\0' + std::string(64, '\0');
}

/// A quarter everywhere but in one channel of pixel (2, 1).
BadFile floatImage(const std::string& folder, const std::string& name, float value, int channels,
                   const std::string& says, int channel = 0) {
    const OIIO::ImageSpec spec(5, 4, channels, OIIO::TypeFloat);
    std::vector<float> samples(std::size_t(20 * channels), 0.25F);
    samples[std::size_t(7 * channels + channel)] = value;
    writeImage(folder + "/" + name, spec, samples);
    return {folder + "/" + name, says};
}

BadFile deepImage(const std::string& folder) {
    OIIO::ImageSpec spec(4, 4, 3, OIIO::TypeHalf);
    spec.deep = true;
    OIIO::DeepData data(spec);
    for (int pixel = 0; pixel < 16; ++pixel) data.set_samples(pixel, 1);
    BadFile file{folder + "/deep.exr", "deep"};
    auto out = OIIO::ImageOutput::create(file.path);
    if (!out || !out->open(file.path, spec) || !out->write_deep_image(data) || !out->close()) {
        throw std::runtime_error(file.path + ": cannot be written");
    }
    return file;
}

}  // namespace

std::vector<BadFile> truncatedFiles(const std::string& folder) {
    std::vector<BadFile> files;
    for (const std::string& image : testImages()) {
        const std::string whole = contentsOf(testImage(image));
        files.push_back(made(folder, "half." + image, whole.substr(0, whole.size() / 2)));
        // The last tenth of a TGA is its footer, and of the multi-image files what is not used.
        const bool ends =
            image.ends_with(".tga") || image == "two_subimages.tif" || image == "mipmap.exr";
        if (ends) continue;
        files.push_back(made(folder, "most." + image, whole.substr(0, whole.size() * 9 / 10)));
    }
    for (const char* image : {"demo.png", "rgb8.jpg", "rgb_half.exr", "rgb8.tif", "rgb8.bmp"}) {
        const std::string whole = contentsOf(testImage(image));
        files.push_back(
            made(folder, std::string("all_but_one.") + image, whole.substr(0, whole.size() - 1)));
    }
    return files;
}

std::vector<BadFile> garbage(const std::string& folder) {
    const std::string noise =
        "no image at all, but text that goes on for some time: " + std::string(100, '?');
    std::vector<BadFile> files = {
        made(folder, "text.txt", noise),
        made(folder, "noise.png", "\x89PNG\r\n\x1a\n" + noise),
        made(folder, "noise.exr", "\x76\x2f\x31\x01" + noise),
        made(folder, "noise2.exr", "\x76\x2f\x31\x01" + little(2, 4) + noise),
        made(folder, "noise.tif", "II" + little(42, 2) + noise),
        made(folder, "noise.jpg", "\xff\xd8\xff\xe0" + noise),
        made(folder, "noise.bmp", "BM" + noise),
        made(folder, "noise.hdr", "#?RADIANCE\n" + noise),
        {folder + "/absent.png", ""},
        {folder, ""}};
    for (const char* kind : {"png", "exr", "tif", "jpg", "bmp", "hdr", "tga"}) {
        files.push_back(made(folder, std::string("empty.") + kind, ""));
    }
    std::string flipped = contentsOf(testImage("demo.png"));
    flipped[flipped.size() / 2] = char(~flipped[flipped.size() / 2]);
    files.push_back(made(folder, "flipped.png", flipped));
    return files;
}

std::vector<BadFile> absurdSizes(const std::string& folder) {
    constexpr std::uint32_t most = 0x7fffffff;
    constexpr std::uint32_t many = 100000;
    return {made(folder, "most.png", pngOfSize(most, most)),
            made(folder, "many.png", pngOfSize(many, many)),
            made(folder, "none.png", pngOfSize(0, 4)),
            made(folder, "most.bmp", bmpOfSize(most, most)),
            made(folder, "many.bmp", bmpOfSize(many, many)),
            made(folder, "none.bmp", bmpOfSize(0, 0)),
            made(folder, "most.tif", tiffOfSize(most, most)),
            made(folder, "many.tif", tiffOfSize(many, many)),
            made(folder, "none.tif", tiffOfSize(0, 0)),
            made(folder, "most.exr", exrOfSize(std::int32_t(most), std::int32_t(most))),
            made(folder, "many.exr", exrOfSize(int(many), int(many))),
            made(folder, "none.exr", exrOfSize(0, 0))};
}

std::vector<BadFile> noTextures(const std::string& folder) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    return {floatImage(folder, "nan.exr", nan, 3, "(2, 1) is not a finite number; 1 such"),
            floatImage(folder, "infinite.exr", infinity, 3, "(2, 1) is not a finite number"),
            floatImage(folder, "nan_alpha.exr", nan, 4, "(2, 1) is not a finite number", 3),
            floatImage(folder, "nan.tif", nan, 3, "(2, 1) is not a finite number"),
            deepImage(folder)};
}

}  // namespace specbake::testing
